/* List of keys: THUD_KEY(where, action, first key, second key, text of the key, label in the bottom line, description).
 * THUD_KEY_AGAIN gives one more key to a listed action. Actions, dispatch, bottom line, help screen and manual are made
 * from it. A label of "" keeps a key out of the bottom line, ~ omits the key before its label, and + puts it behind all
 * others, if there is room. A key may differ between screens; a screen's own keys come before the general ones. */
THUD_KEY(MODEL, ALL_FLOORS, '=', 0, "=", "all floors", "copy this floor's value to every floor of the structure")
THUD_KEY(MODEL, ADD_STOREY, 'a', 0, "a", "add", "add a storey above this one")
THUD_KEY(MODEL, DELETE_STOREY, 'd', 0, "d", "delete", "delete this storey")
THUD_KEY(MODEL, ADD_STRUCTURE, 'A', 0, "A", "+structure", "add a structure to the right of this one")
THUD_KEY(MODEL, REMOVE_STRUCTURE, 'D', 0, "D", "+remove", "remove this structure")
THUD_KEY(MODEL, SWAP, 'x', 0, "x", "swap", "swap the two structures shown, left and right")
THUD_KEY(CONTACT, KEEP_FORCE, 'f', 0, "f", "keep F",
         "after a change of the exponent: choose the stiffness that keeps F(delta_u)")
THUD_KEY(CONTACT, TOGGLE_BUMPER, 'B', 0, "B", "bumper", "insert or remove the bumper")
THUD_KEY(CONTACT, ADD_LINK, 'a', 0, "a", "link", "add a link: a dashpot between the topmost common floors")
THUD_KEY(CONTACT, DELETE_LINK, 'd', 0, "d", "", "delete the link under the cursor")
THUD_KEY(CONTACT, NARROWER, '(', 0, "(", "~( ) drag the gap",
         "reduce the gap by a millimetre, faster while held (mouse: drag the buildings)")
THUD_KEY(CONTACT, WIDER, ')', 0, ")", "", "increase the gap by a millimetre")
THUD_KEY(CONTACT, QUANTITY, 'c', 0, "c", "buildings",
         "show the buildings at the largest impact or the curve of the law (both if there is room)")
THUD_KEY(MODEL_CONTACT, PREVIOUS_PAIR, '[', 0, "[", "", "go to the pair of structures (the interface) to the left")
THUD_KEY(MODEL_CONTACT, NEXT_PAIR, ']', 0, "]", "", "go to the pair of structures (the interface) to the right")
THUD_KEY(RECORD, MARK, ' ', 0, "Space", "suite",
         "add the ground motion to the study's suite or remove it; asks for what its file does not state")
THUD_KEY(RECORD, FILTER, 'f', 0, "f", "filter", "show only the files whose name contains some text")
THUD_KEY(RECORD, SIGN, 's', 0, "s", "sign", "flip the sign of the ground motion")
THUD_KEY_AGAIN(RECORD, QUANTITY, 'c', 0, "c", "curve", "show acceleration, velocity, displacement or response spectrum")
THUD_KEY(RESULTS, SORT, 's', 0, "s", "sort",
         "sort the impacts by time, force or floor; the floors by height or by value")
THUD_KEY_AGAIN(RESULTS, FILTER, 'f', 0, "f", "filter", "show only the rows that contain some text, such as A 4")
THUD_KEY(RESULTS, CASE, 'b', 0, "b", "case", "choose the case whose impacts and energies are shown")
THUD_KEY_AGAIN(RESULTS, QUANTITY, 'c', 0, "c", "quantities",
               "show accelerations and drifts, or displacements and velocities (all four if there is room)")
THUD_KEY(PLOTS, PLAY, ' ', 0, "Space", "play", "start or stop the animation")
THUD_KEY(PLOTS, FASTER, '+', 0, "+", "", "play faster")
THUD_KEY(PLOTS, SLOWER, '-', 0, "-", "~+/- speed", "play slower")
THUD_KEY(PLOTS, SCRUB_BACK, THUD_KEY_LEFT, 'h', "Left", "", "go one step back in time")
THUD_KEY(PLOTS, SCRUB_FORWARD, THUD_KEY_RIGHT, 'l', "Right", "~Left/Right time", "go one step forward in time")
THUD_KEY(PLOTS, NEXT_IMPACT, 'n', 0, "n", "~n/N impact", "go to the next impact")
THUD_KEY(PLOTS, PREVIOUS_IMPACT, 'N', 0, "N", "", "go to the previous impact")
THUD_KEY(PLOTS, LARGEST_IMPACT, 'L', 0, "L", "largest", "go to the impact with the largest force")
THUD_KEY_AGAIN(PLOTS, CASE, 'b', 0, "b", "case", "choose the animated case")
THUD_KEY(PLOTS, NEXT_FIGURE, THUD_KEY_DOWN, 'j', "Down", "~Up/Down figure", "go to the next figure")
THUD_KEY(PLOTS, PREVIOUS_FIGURE, THUD_KEY_UP, 'k', "Up", "", "go to the previous figure")
THUD_KEY(PLOTS, NEXT_CONTACT, ']', 0, "]", "~[ ] floor", "go to the contact or floor above")
THUD_KEY(PLOTS, PREVIOUS_CONTACT, '[', 0, "[", "", "go to the contact or floor below")
THUD_KEY_AGAIN(PLOTS_SIDE, TOGGLE_BUMPER, 'B', 0, "B", "", "insert or remove the bumper")
THUD_KEY_AGAIN(SWEEP, QUANTITY, 'c', 0, "c", "figure", "show the next figure of the study")
THUD_KEY_AGAIN(SWEEP, NEXT_CONTACT, ']', 0, "]", "~[ ] panel",
               "show only the next panel of the figure; after the last, all of them")
THUD_KEY_AGAIN(SWEEP, PREVIOUS_CONTACT, '[', 0, "[", "", "show the previous panel")
THUD_KEY_AGAIN(SWEEP, RIGHT, THUD_KEY_RIGHT, 'l', "Right", "",
               "on the curves: read the next value of the first varied key; Enter sets it in the scene")
THUD_KEY_AGAIN(SWEEP, LEFT, THUD_KEY_LEFT, 'h', "Left", "", "on the curves: read the previous value")
THUD_KEY(HELP, SEARCH, '/', 0, "/", "search", "search in the help")
THUD_KEY(HELP, NEXT_MATCH, 'n', 0, "n", "~n/N match", "go to the next match")
THUD_KEY(HELP, PREVIOUS_MATCH, 'N', 0, "N", "", "go to the previous match")
THUD_KEY(FORMS, EDIT, THUD_KEY_ENTER, 0, "Enter", "edit",
         "edit the field (typing replaces its text), or choose the item under the cursor")
THUD_KEY(FORMS, EDIT_OLD, THUD_KEY_F2, 0, "F2", "",
         "edit the field from the end of its text (Enter: the first key replaces it)")
THUD_KEY(FORMS, TOGGLE, ' ', 0, "Space", "", "switch on or off, or take the next choice")
THUD_KEY(FORMS, STEP_UP, '+', 0, "+", "", "increase by one step (mouse: drag the value)")
THUD_KEY(FORMS, STEP_DOWN, '-', 0, "-", "~+/- step", "decrease by one step")
THUD_KEY(FORMS, LEAP_UP, '}', 0, "}", "", "increase by ten steps")
THUD_KEY(FORMS, LEAP_DOWN, '{', 0, "{", "", "decrease by ten steps")
THUD_KEY(
    FORMS, SOLVE, 'G', 0, "G", "+solve",
    "find the value of this field that meets a criterion (force < 10 MN, drift < 1 %, no pounding); Enter takes it")
THUD_KEY(FORMS, NEW, 'n', 0, "n", "new", "create a scene: two neighbours, their gap and a ground motion")
THUD_KEY(GENERAL, RUN, 'r', 0, "r", "run", "run the three cases now (on Sweep the study)")
THUD_KEY(GENERAL, UNDO, 'u', 0, "u", "undo", "undo the last change")
THUD_KEY(GENERAL, REDO, THUD_CTRL('r'), 0, "^R", "+redo", "redo the last undone change")
THUD_KEY(GENERAL, DESIGNS, 'U', 0, "U", "+designs",
         "list the designs of this session with their results: open, compare, name or mark one for the report")
THUD_KEY(GENERAL, PICTURE, 'p', 0, "p", "PNG", "save the shown figure as PNG")
THUD_KEY(GENERAL, PICTURES, 'P', 0, "P", "+all PNG",
         "save the figures marked on the shelf as PNG; if none is marked, all of this screen")
THUD_KEY(GENERAL, SHELF, 'F', 0, "F", "+figures", "open the shelf: view, mark and save every figure")
THUD_KEY(GENERAL, EXPORT, 'e', 0, "e", "CSV", "save the shown numbers as CSV")
THUD_KEY(GENERAL, COPY, 'y', 0, "y", "+copy",
         "copy the numbers of this pane, or the data of a chart, to the clipboard (OSC 52)")
THUD_KEY(GENERAL, REPORT, 'R', 0, "R", "+report",
         "open the form of `thud report`: a document on this preset (:gap, :fragility, :bench, :simplify, :export and "
         "others have forms too)")
THUD_KEY(GENERAL, ZOOM, 'z', 0, "z", "zoom",
         "show less of the chart, around its cursor (the wheel: around the pointer; dragging moves it)")
THUD_KEY(GENERAL, UNZOOM, 'Z', 0, "Z", "+wider", "show more of the chart")
THUD_KEY(GENERAL, SAVE, 'w', 0, "w", "save", "save the preset and keep its comments")
THUD_KEY(GENERAL, SAVE_AS, 'W', 0, "W", "+save as", "save the preset under another name")
THUD_KEY(GENERAL, OPEN, 'o', 0, "o", "open", "open another preset")
THUD_KEY(GENERAL, REMARKS, '!', 0, "!", "+remarks",
         "list the remarks counted above, energy, tolerance and sign; each leads to its field")
THUD_KEY(GENERAL, FIND, '/', THUD_CTRL('p'), "/", "find",
         "find anything by letters of its name (also Ctrl-P): fields, figures, screens, keys, commands, presets, "
         "ground motions, states, lines of study and help")
THUD_KEY(GENERAL, COMMAND, ':', 0, ":", "+command",
         "open the command line: set KEY VALUE, case, record, run, open, w, q, ...")
THUD_KEY(GENERAL, MESSAGES, THUD_CTRL('o'), 0, "^O", "", "list the actions and messages so far")
THUD_KEY(GENERAL, HELP, '?', THUD_KEY_F1, "?", "help", "show the keys, and the model in short")
THUD_KEY(GENERAL, QUIT, 'q', 0, "q", "quit", "go back one level; at the top, quit (asks if something is unsaved)")
THUD_KEY(GENERAL, BACK, THUD_KEY_ESC, 0, "Esc", "",
         "cancel the runs, or go back one level, also from a screen chosen by mistake; never quits")
THUD_KEY(GENERAL, NEXT_PANE, THUD_KEY_TAB, 0, "Tab", "pane", "go to the next pane")
THUD_KEY(GENERAL, PREVIOUS_PANE, THUD_KEY_BACKTAB, 0, "S-Tab", "", "go to the previous pane")
THUD_KEY(GENERAL, NEXT_SCREEN, '>', 0, ">", "", "go to the next screen (1 to 7: that screen)")
THUD_KEY(GENERAL, PREVIOUS_SCREEN, '<', 0, "<", "", "go to the previous screen")
THUD_KEY(GENERAL, GO, 'g', 0, "g", "", "g and a digit: go to that screen, as by the digit alone or with Alt")
THUD_KEY(GENERAL, UP, THUD_KEY_UP, 'k', "Up", "", "up")
THUD_KEY(GENERAL, DOWN, THUD_KEY_DOWN, 'j', "Down", "", "down")
THUD_KEY(GENERAL, LEFT, THUD_KEY_LEFT, 'h', "Left", "", "left")
THUD_KEY(GENERAL, RIGHT, THUD_KEY_RIGHT, 'l', "Right", "", "right")
THUD_KEY(GENERAL, PAGE_UP, THUD_KEY_PAGE_UP, 0, "PgUp", "", "a page up")
THUD_KEY(GENERAL, PAGE_DOWN, THUD_KEY_PAGE_DOWN, 0, "PgDn", "", "a page down")
THUD_KEY(GENERAL, FIRST, THUD_KEY_HOME, 0, "Home", "", "the first")
THUD_KEY(GENERAL, LAST, THUD_KEY_END, 0, "End", "", "the last")
THUD_KEY(GENERAL, MOUSE, 'm', 0, "m", "+mouse", "switch the mouse on or off (off: the terminal's own selection works)")
THUD_KEY(GENERAL, REPAINT, THUD_CTRL('l'), 0, "^L", "", "redraw the screen")
THUD_KEY(TYPING, ACCEPT, THUD_KEY_ENTER, 0, "Enter", "accept", "accept the text")
THUD_KEY(TYPING, CANCEL, THUD_KEY_ESC, 0, "Esc", "end", "cancel the edit")
THUD_KEY(TYPING, CLEAR, THUD_CTRL('u'), 0, "^U", "clear", "clear the text")
THUD_KEY(TYPING, ACCEPT_NEXT, THUD_KEY_TAB, 0, "Tab", "~Tab next", "accept the text and edit the next field")
THUD_KEY(TYPING, ACCEPT_PREVIOUS, THUD_KEY_BACKTAB, 0, "S-Tab", "", "accept the text and edit the previous field")
THUD_KEY(TYPING, ACCEPT_DOWN, THUD_KEY_DOWN, 0, "Down", "~Up/Down accept, edit that one",
         "accept the text and edit the field below")
THUD_KEY(TYPING, ACCEPT_UP, THUD_KEY_UP, 0, "Up", "", "accept the text and edit the field above")
THUD_KEY_AGAIN(CHOOSING, ACCEPT, THUD_KEY_ENTER, 0, "Enter", "choose", "choose the marked line")
THUD_KEY_AGAIN(CHOOSING, CANCEL, THUD_KEY_ESC, 0, "Esc", "cancel", "cancel without a change")
THUD_KEY_AGAIN(CHOOSING, UP, THUD_KEY_UP, 0, "Up", "", "up")
THUD_KEY_AGAIN(CHOOSING, DOWN, THUD_KEY_DOWN, 0, "Down", "~Up/Down move", "down")
THUD_KEY_AGAIN(CHOOSING, PAGE_UP, THUD_KEY_PAGE_UP, 0, "PgUp", "", "a page up")
THUD_KEY_AGAIN(CHOOSING, PAGE_DOWN, THUD_KEY_PAGE_DOWN, 0, "PgDn", "", "a page down")
THUD_KEY_AGAIN(CHOOSING, CLEAR, THUD_CTRL('u'), 0, "^U", "clear", "clear the text that narrows the list")
THUD_KEY_AGAIN(NEW, ACCEPT, THUD_KEY_ENTER, 0, "Enter", "do it",
               "create the scene from these values and go to Model; in the form of a command, run it")
THUD_KEY_AGAIN(NEW, CANCEL, THUD_KEY_ESC, 0, "Esc", "cancel", "go back without a change")
THUD_KEY_AGAIN(NEW, ACCEPT_NEXT, THUD_KEY_TAB, 0, "Tab", "next",
               "go to the next value; on the ground motion, take the first file that matches")
THUD_KEY_AGAIN(NEW, ACCEPT_PREVIOUS, THUD_KEY_BACKTAB, 0, "S-Tab", "", "go to the previous value")
THUD_KEY_AGAIN(NEW, ACCEPT_DOWN, THUD_KEY_DOWN, 0, "Down", "~Up/Down move", "go to the value below")
THUD_KEY_AGAIN(NEW, ACCEPT_UP, THUD_KEY_UP, 0, "Up", "", "go to the value above")
THUD_KEY_AGAIN(SHELF, MARK, ' ', 0, "Space", "mark", "mark or unmark the figure")
THUD_KEY_AGAIN(SHELF, PICTURES, 'P', 'p', "P", "write", "save the marked figures, or all if none is marked")
THUD_KEY_AGAIN(SHELF, REPORT, 'R', 0, "R", "report",
               "draw the marked figures for the report, and open its form with them")
THUD_KEY_AGAIN(SHELF, SAVE, 'w', 0, "w", "", "save the preset of the report")
THUD_KEY_AGAIN(SHELF, CANCEL, THUD_KEY_ESC, 'q', "Esc", "close", "go back to the screen; marks are kept")
THUD_KEY_AGAIN(SHELF, NEXT_CONTACT, ']', 0, "]", "~[ ] panel", "show only the next panel; after the last, all")
THUD_KEY_AGAIN(SHELF, PREVIOUS_CONTACT, '[', 0, "[", "", "show the previous panel")
THUD_KEY_AGAIN(SHELF, UP, THUD_KEY_UP, 'k', "Up", "", "go to the figure above")
THUD_KEY_AGAIN(SHELF, DOWN, THUD_KEY_DOWN, 'j', "Down", "~Up/Down look", "go to the figure below")
THUD_KEY_AGAIN(SHELF, PAGE_UP, THUD_KEY_PAGE_UP, 0, "PgUp", "", "half a screen up")
THUD_KEY_AGAIN(SHELF, PAGE_DOWN, THUD_KEY_PAGE_DOWN, 0, "PgDn", "", "half a screen down")
THUD_KEY_AGAIN(DESIGNS, ACCEPT, THUD_KEY_ENTER, 0, "Enter", "go there", "set the scene to this design")
THUD_KEY(DESIGNS, COMPARE, THUD_KEY_TAB, 'c', "Tab", "compare",
         "compare everything with this design; again: with the state before each change")
THUD_KEY_AGAIN(DESIGNS, MARK, ' ', 0, "Space", "mark",
               "add the design to the report as a preset of its own, or remove it")
THUD_KEY(DESIGNS, NAME, THUD_KEY_F2, 'n', "F2", "name", "name the design, and save it as a preset of that name")
THUD_KEY(DESIGNS, SUITE, 's', 0, "s", "suite",
         "run every design over the study's ground motions and show the largest values; again: over the scene's own")
THUD_KEY(DESIGNS, FORGET, THUD_KEY_DELETE, 'd', "Del", "forget", "forget the design")
THUD_KEY_AGAIN(DESIGNS, REPORT, 'R', 0, "R", "report", "open the form of the report, with the marked designs")
THUD_KEY_AGAIN(DESIGNS, SAVE, 'w', 0, "w", "", "save the preset of the report")
THUD_KEY_AGAIN(DESIGNS, CANCEL, THUD_KEY_ESC, 'q', "Esc", "close", "go back to the screen")
THUD_KEY_AGAIN(DESIGNS, UP, THUD_KEY_UP, 'k', "Up", "", "go to the design above")
THUD_KEY_AGAIN(DESIGNS, DOWN, THUD_KEY_DOWN, 'j', "Down", "", "go to the design below")
