/* Every key there is: THUD_KEY(where, action, first key, second key, how it is written, label in the bottom line, what
 * it does). THUD_KEY_AGAIN is one more key for an action already in the list. From this one list come the actions, the
 * dispatch, the bottom line, the help screen and the manual. A label of "" keeps a key out of the bottom line, one that
 * starts with ~ stands there without the key before it, one that starts with + behind all others, where there is room. The same key may stand for different actions on different
 * screens; a screen's own come before the general ones. */
THUD_KEY(MODEL, ALL_FLOORS, '=', 0, "=", "all floors", "copy this floor's value to every floor of the structure")
THUD_KEY(MODEL, ADD_STOREY, 'a', 0, "a", "add", "add a storey above this one")
THUD_KEY(MODEL, DELETE_STOREY, 'd', 0, "d", "delete", "delete this storey")
THUD_KEY(MODEL, ADD_STRUCTURE, 'A', 0, "A", "+structure", "add a structure to the right of this one")
THUD_KEY(MODEL, REMOVE_STRUCTURE, 'D', 0, "D", "+remove", "remove this structure")
THUD_KEY(MODEL, SWAP, 'x', 0, "x", "swap", "swap the two structures shown, left and right")
THUD_KEY(CONTACT, KEEP_FORCE, 'f', 0, "f", "keep F",
         "after a change of the exponent: choose the stiffness so that F(delta_u) is as before")
THUD_KEY(CONTACT, TOGGLE_BUMPER, 'B', 0, "B", "bumper", "put the bumper in or take it out")
THUD_KEY(CONTACT, ADD_LINK, 'a', 0, "a", "link",
         "tie the two by one more link, a dashpot between their topmost common floors")
THUD_KEY(CONTACT, DELETE_LINK, 'd', 0, "d", "", "take the link under the cursor away")
THUD_KEY(CONTACT, NARROWER, '(', 0, "(", "~( ) drag the gap",
         "the gap a millimetre narrower, held faster (the mouse: pull the buildings)")
THUD_KEY(CONTACT, WIDER, ')', 0, ")", "", "the gap a millimetre wider")
THUD_KEY(CONTACT, QUANTITY, 'c', 0, "c", "buildings",
         "the buildings at the largest impact, or the curve of the law (both where there is room)")
THUD_KEY(MODEL_CONTACT, PREVIOUS_PAIR, '[', 0, "[", "", "the pair of structures (the interface) to the left")
THUD_KEY(MODEL_CONTACT, NEXT_PAIR, ']', 0, "]", "", "the pair of structures (the interface) to the right")
THUD_KEY(RECORD, MARK, ' ', 0, "Space", "suite",
         "put the ground motion into the study's suite, or take it out; what is missing to read it is asked for")
THUD_KEY(RECORD, FILTER, 'f', 0, "f", "filter", "show only the files whose name contains some text")
THUD_KEY(RECORD, SIGN, 's', 0, "s", "sign", "flip the sign of the ground motion")
THUD_KEY_AGAIN(RECORD, QUANTITY, 'c', 0, "c", "curve", "acceleration, velocity, displacement or response spectrum")
THUD_KEY(RESULTS, SORT, 's', 0, "s", "sort",
         "sort the impacts by time, force or floor; the floors by height, or the largest first")
THUD_KEY_AGAIN(RESULTS, FILTER, 'f', 0, "f", "filter", "show only the rows that contain some text, such as A 4")
THUD_KEY(RESULTS, CASE, 'b', 0, "b", "case", "the case whose impacts and energies are shown")
THUD_KEY_AGAIN(RESULTS, QUANTITY, 'c', 0, "c", "quantities",
               "accelerations and drifts, or displacements and velocities (all four where there is room)")
THUD_KEY(PLOTS, PLAY, ' ', 0, "Space", "play", "start and stop the movement")
THUD_KEY(PLOTS, FASTER, '+', 0, "+", "", "play faster")
THUD_KEY(PLOTS, SLOWER, '-', 0, "-", "~+/- speed", "play slower")
THUD_KEY(PLOTS, SCRUB_BACK, THUD_KEY_LEFT, 'h', "Left", "", "one step back in time")
THUD_KEY(PLOTS, SCRUB_FORWARD, THUD_KEY_RIGHT, 'l', "Right", "~Left/Right time", "one step forward in time")
THUD_KEY(PLOTS, NEXT_IMPACT, 'n', 0, "n", "~n/N impact", "go to the next impact")
THUD_KEY(PLOTS, PREVIOUS_IMPACT, 'N', 0, "N", "", "go to the impact before")
THUD_KEY(PLOTS, LARGEST_IMPACT, 'L', 0, "L", "largest", "go to the impact with the largest force")
THUD_KEY_AGAIN(PLOTS, CASE, 'b', 0, "b", "case", "the case that moves")
THUD_KEY(PLOTS, NEXT_FIGURE, THUD_KEY_DOWN, 'j', "Down", "~Up/Down figure", "the next figure")
THUD_KEY(PLOTS, PREVIOUS_FIGURE, THUD_KEY_UP, 'k', "Up", "", "the figure before")
THUD_KEY(PLOTS, NEXT_CONTACT, ']', 0, "]", "~[ ] floor", "the contact or floor above")
THUD_KEY(PLOTS, PREVIOUS_CONTACT, '[', 0, "[", "", "the contact or floor below")
THUD_KEY_AGAIN(PLOTS_SIDE, TOGGLE_BUMPER, 'B', 0, "B", "", "put the bumper in or take it out")
THUD_KEY_AGAIN(SWEEP, QUANTITY, 'c', 0, "c", "figure", "the next figure of the study")
THUD_KEY_AGAIN(SWEEP, NEXT_CONTACT, ']', 0, "]", "~[ ] panel",
               "the next panel of the figure alone, after the last all of them")
THUD_KEY_AGAIN(SWEEP, PREVIOUS_CONTACT, '[', 0, "[", "", "the panel before")
THUD_KEY_AGAIN(SWEEP, RIGHT, THUD_KEY_RIGHT, 'l', "Right", "",
               "on the curves: read the next value of the first varied key; Enter gives it to the scene")
THUD_KEY_AGAIN(SWEEP, LEFT, THUD_KEY_LEFT, 'h', "Left", "", "on the curves: read the value before")
THUD_KEY(HELP, SEARCH, '/', 0, "/", "search", "search in the help")
THUD_KEY(HELP, NEXT_MATCH, 'n', 0, "n", "~n/N match", "the next match")
THUD_KEY(HELP, PREVIOUS_MATCH, 'N', 0, "N", "", "the match before")
THUD_KEY(FORMS, EDIT, THUD_KEY_ENTER, 0, "Enter", "edit",
         "edit the field (what is typed replaces the text), or choose what the cursor is on")
THUD_KEY(FORMS, EDIT_OLD, THUD_KEY_F2, 0, "F2", "",
         "edit the field from the end of its text (Enter: the first key replaces it)")
THUD_KEY(FORMS, TOGGLE, ' ', 0, "Space", "", "turn on or off, or the next choice")
THUD_KEY(FORMS, STEP_UP, '+', 0, "+", "", "one step up")
THUD_KEY(FORMS, STEP_DOWN, '-', 0, "-", "~+/- step", "one step down")
THUD_KEY(FORMS, LEAP_UP, '}', 0, "}", "", "ten steps up")
THUD_KEY(FORMS, LEAP_DOWN, '{', 0, "{", "", "ten steps down")
THUD_KEY(FORMS, SOLVE, 'G', 0, "G", "+solve",
         "which value of this field makes something hold (force < 10 MN, drift < 1 %, no pounding); Enter takes it")
THUD_KEY(FORMS, NEW, 'n', 0, "n", "new", "a new scene: two neighbours, their gap and a ground motion from nothing")
THUD_KEY(GENERAL, RUN, 'r', 0, "r", "run", "run the three cases now (on Sweep the study)")
THUD_KEY(GENERAL, UNDO, 'u', 0, "u", "undo", "undo the last change")
THUD_KEY(GENERAL, REDO, THUD_CTRL('r'), 0, "^R", "+redo", "do again what was undone")
THUD_KEY(GENERAL, DESIGNS, 'U', 0, "U", "+designs",
         "the designs of this session with their results: go to one, compare with it, name it, mark it for the report")
THUD_KEY(GENERAL, PICTURE, 'p', 0, "p", "PNG", "write the figure shown as PNG")
THUD_KEY(GENERAL, PICTURES, 'P', 0, "P", "+all PNG",
         "write the figures marked on the shelf as PNG, all of this screen where none is marked")
THUD_KEY(GENERAL, SHELF, 'F', 0, "F", "+figures",
         "the shelf: every figure there is, to be looked at, marked and written")
THUD_KEY(GENERAL, EXPORT, 'e', 0, "e", "CSV", "write the numbers shown as CSV")
THUD_KEY(GENERAL, COPY, 'y', 0, "y", "+copy",
         "copy the numbers of this pane, of a chart its data, to the clipboard (OSC 52)")
THUD_KEY(GENERAL, REPORT, 'R', 0, "R", "+report",
         "the form of `thud report`: a document about this preset (:gap, :fragility, :bench, :simplify, :export and "
         "others have one too)")
THUD_KEY(GENERAL, ZOOM, 'z', 0, "z", "zoom",
         "show less of the chart, around its cursor (the wheel: around the pointer; dragging moves it)")
THUD_KEY(GENERAL, UNZOOM, 'Z', 0, "Z", "+wider", "show more of the chart")
THUD_KEY(GENERAL, SAVE, 'w', 0, "w", "save", "save the preset, comments kept")
THUD_KEY(GENERAL, SAVE_AS, 'W', 0, "W", "+save as", "save the preset under another name")
THUD_KEY(GENERAL, OPEN, 'o', 0, "o", "open", "open another preset")
THUD_KEY(GENERAL, REMARKS, '!', 0, "!", "+remarks",
         "the remarks counted above, energy, tolerance and sign: a list that leads to their fields")
THUD_KEY(GENERAL, FIND, '/', THUD_CTRL('p'), "/", "find",
         "find anything by letters of its name (Ctrl-P too): fields, figures, screens, keys, commands, presets, ground "
         "motions, states, lines of the study and of the help")
THUD_KEY(GENERAL, COMMAND, ':', 0, ":", "+command", "a command line: set KEY VALUE, case, record, run, open, w, q, ...")
THUD_KEY(GENERAL, MESSAGES, THUD_CTRL('o'), 0, "^O", "", "what was done and said so far")
THUD_KEY(GENERAL, HELP, '?', THUD_KEY_F1, "?", "help", "the keys, and the model in short")
THUD_KEY(GENERAL, QUIT, 'q', 0, "q", "quit", "back one level; at the top, quit (asks when something is unsaved)")
THUD_KEY(GENERAL, BACK, THUD_KEY_ESC, 0, "Esc", "",
         "cancel what runs, or back one level, also from a screen chosen by mistake; never quits")
THUD_KEY(GENERAL, NEXT_PANE, THUD_KEY_TAB, 0, "Tab", "pane", "the next pane")
THUD_KEY(GENERAL, PREVIOUS_PANE, THUD_KEY_BACKTAB, 0, "S-Tab", "", "the pane before")
THUD_KEY(GENERAL, NEXT_SCREEN, '>', 0, ">", "", "the next screen (1 to 7: that screen)")
THUD_KEY(GENERAL, PREVIOUS_SCREEN, '<', 0, "<", "", "the screen before")
THUD_KEY(GENERAL, GO, 'g', 0, "g", "", "g and a digit: that screen, as the digit alone or with Alt")
THUD_KEY(GENERAL, UP, THUD_KEY_UP, 'k', "Up", "", "up")
THUD_KEY(GENERAL, DOWN, THUD_KEY_DOWN, 'j', "Down", "", "down")
THUD_KEY(GENERAL, LEFT, THUD_KEY_LEFT, 'h', "Left", "", "left")
THUD_KEY(GENERAL, RIGHT, THUD_KEY_RIGHT, 'l', "Right", "", "right")
THUD_KEY(GENERAL, PAGE_UP, THUD_KEY_PAGE_UP, 0, "PgUp", "", "a page up")
THUD_KEY(GENERAL, PAGE_DOWN, THUD_KEY_PAGE_DOWN, 0, "PgDn", "", "a page down")
THUD_KEY(GENERAL, FIRST, THUD_KEY_HOME, 0, "Home", "", "the first")
THUD_KEY(GENERAL, LAST, THUD_KEY_END, 0, "End", "", "the last")
THUD_KEY(GENERAL, MOUSE, 'm', 0, "m", "+mouse", "mouse on or off (off: the terminal's own selection works)")
THUD_KEY(GENERAL, REPAINT, THUD_CTRL('l'), 0, "^L", "", "redraw the screen")
THUD_KEY(TYPING, ACCEPT, THUD_KEY_ENTER, 0, "Enter", "accept", "take what was typed")
THUD_KEY(TYPING, CANCEL, THUD_KEY_ESC, 0, "Esc", "end", "leave this field as it was")
THUD_KEY(TYPING, CLEAR, THUD_CTRL('u'), 0, "^U", "clear", "clear the text")
THUD_KEY(TYPING, ACCEPT_NEXT, THUD_KEY_TAB, 0, "Tab", "~Tab next", "take it and edit the next field")
THUD_KEY(TYPING, ACCEPT_PREVIOUS, THUD_KEY_BACKTAB, 0, "S-Tab", "", "take it and edit the field before")
THUD_KEY(TYPING, ACCEPT_DOWN, THUD_KEY_DOWN, 0, "Down", "~Up/Down take it and edit that one",
         "take it and edit the field below")
THUD_KEY(TYPING, ACCEPT_UP, THUD_KEY_UP, 0, "Up", "", "take it and edit the field above")
THUD_KEY_AGAIN(CHOOSING, ACCEPT, THUD_KEY_ENTER, 0, "Enter", "choose", "take the marked line")
THUD_KEY_AGAIN(CHOOSING, CANCEL, THUD_KEY_ESC, 0, "Esc", "cancel", "leave everything as it was")
THUD_KEY_AGAIN(CHOOSING, UP, THUD_KEY_UP, 0, "Up", "", "up")
THUD_KEY_AGAIN(CHOOSING, DOWN, THUD_KEY_DOWN, 0, "Down", "~Up/Down move", "down")
THUD_KEY_AGAIN(CHOOSING, PAGE_UP, THUD_KEY_PAGE_UP, 0, "PgUp", "", "a page up")
THUD_KEY_AGAIN(CHOOSING, PAGE_DOWN, THUD_KEY_PAGE_DOWN, 0, "PgDn", "", "a page down")
THUD_KEY_AGAIN(CHOOSING, CLEAR, THUD_CTRL('u'), 0, "^U", "clear", "clear what was typed to narrow the list")
THUD_KEY_AGAIN(NEW, ACCEPT, THUD_KEY_ENTER, 0, "Enter", "do it",
               "make the scene of what stands there, and go to Model; in the form of a command, run it")
THUD_KEY_AGAIN(NEW, CANCEL, THUD_KEY_ESC, 0, "Esc", "cancel", "back to what was there")
THUD_KEY_AGAIN(NEW, ACCEPT_NEXT, THUD_KEY_TAB, 0, "Tab", "next",
               "the next value; on the ground motion the first file that fits what was typed")
THUD_KEY_AGAIN(NEW, ACCEPT_PREVIOUS, THUD_KEY_BACKTAB, 0, "S-Tab", "", "the value before")
THUD_KEY_AGAIN(NEW, ACCEPT_DOWN, THUD_KEY_DOWN, 0, "Down", "~Up/Down move", "the value below")
THUD_KEY_AGAIN(NEW, ACCEPT_UP, THUD_KEY_UP, 0, "Up", "", "the value above")
THUD_KEY_AGAIN(SHELF, MARK, ' ', 0, "Space", "mark", "mark the figure, or take its mark away")
THUD_KEY_AGAIN(SHELF, PICTURES, 'P', 'p', "P", "write", "write the marked figures, where none is marked all")
THUD_KEY_AGAIN(SHELF, REPORT, 'R', 0, "R", "report",
               "draw the marked figures for the report, and open its form with them")
THUD_KEY_AGAIN(SHELF, SAVE, 'w', 0, "w", "", "save the preset, of which the report is")
THUD_KEY_AGAIN(SHELF, CANCEL, THUD_KEY_ESC, 'q', "Esc", "close", "back to the screen; what is marked stays so")
THUD_KEY_AGAIN(SHELF, NEXT_CONTACT, ']', 0, "]", "~[ ] panel", "the next panel of the figure alone, after the last all")
THUD_KEY_AGAIN(SHELF, PREVIOUS_CONTACT, '[', 0, "[", "", "the panel before")
THUD_KEY_AGAIN(SHELF, UP, THUD_KEY_UP, 'k', "Up", "", "the figure above")
THUD_KEY_AGAIN(SHELF, DOWN, THUD_KEY_DOWN, 'j', "Down", "~Up/Down look", "the figure below")
THUD_KEY_AGAIN(SHELF, PAGE_UP, THUD_KEY_PAGE_UP, 0, "PgUp", "", "half a screen up")
THUD_KEY_AGAIN(SHELF, PAGE_DOWN, THUD_KEY_PAGE_DOWN, 0, "PgDn", "", "half a screen down")
THUD_KEY_AGAIN(DESIGNS, ACCEPT, THUD_KEY_ENTER, 0, "Enter", "go there", "the scene becomes this design")
THUD_KEY(DESIGNS, COMPARE, THUD_KEY_TAB, 'c', "Tab", "compare",
         "tell and draw everything against this design; again: against the state before each change")
THUD_KEY_AGAIN(DESIGNS, MARK, ' ', 0, "Space", "mark",
               "put the design into the report, as a preset of its own, or take it out")
THUD_KEY(DESIGNS, NAME, THUD_KEY_F2, 'n', "F2", "name", "give the design a name, and save it so as a preset")
THUD_KEY(DESIGNS, SUITE, 's', 0, "s", "suite",
         "every design over the ground motions of the study, the largest of each; again: over the scene's own")
THUD_KEY(DESIGNS, FORGET, THUD_KEY_DELETE, 'd', "Del", "forget", "forget the design")
THUD_KEY_AGAIN(DESIGNS, REPORT, 'R', 0, "R", "report", "the form of the report, with the marked designs")
THUD_KEY_AGAIN(DESIGNS, SAVE, 'w', 0, "w", "", "save the preset, of which the report is")
THUD_KEY_AGAIN(DESIGNS, CANCEL, THUD_KEY_ESC, 'q', "Esc", "close", "back to the screen")
THUD_KEY_AGAIN(DESIGNS, UP, THUD_KEY_UP, 'k', "Up", "", "the design above")
THUD_KEY_AGAIN(DESIGNS, DOWN, THUD_KEY_DOWN, 'j', "Down", "", "the design below")
