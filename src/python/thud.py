"""Earthquake pounding of neighbouring buildings from Python: thud's library by ctypes; thud(3) describes what it calls.

    import thud
    thud.run("towers", gap="12 cm").floors["A"].acceleration     # peaks of A's floors, lowest first, m/s2
    pandas.DataFrame(thud.sweep("towers", {"gap": "5cm:25cm:1cm"}, which="none,bumper"))

Values are set by their keys of thud-preset(5), as text with a unit or as a number in SI: `set={"bumper.thickness": 0.05}`,
or as keywords with `__` for a dot and `_` for a hyphen, `bumper__thickness="5 cm"`. Columns are NumPy arrays where there
is NumPy, else memoryviews of doubles; either keeps the results alive. The library is the one that THUD_LIBRARY names,
else the first of: beside this file, in the libdir that pkg-config knows, where the loader looks.
"""
import ctypes
import os
import subprocess
from ctypes import CFUNCTYPE, POINTER, byref, c_char, c_char_p, c_double, c_int, c_size_t, c_void_p

try:
    import numpy
except ImportError:
    numpy = None

def _places():
    named, name = os.environ.get("THUD_LIBRARY"), "libthud.so.0"
    if named:
        return [named]
    here = os.path.dirname(os.path.abspath(__file__))
    places = [os.path.join(here, name), os.path.normpath(os.path.join(here, "..", "..", "lib", name))] # share/thud of an installation
    try:
        folder = subprocess.run(["pkg-config", "--variable=libdir", "thud"], capture_output=True, text=True, check=True).stdout
        places.append(os.path.join(folder.strip(), name))
    except (OSError, subprocess.CalledProcessError):
        pass  # no pkg-config, or it knows no thud
    return [*places, name]

def _load():
    tried = []
    for place in _places():
        try:
            return ctypes.CDLL(place)
        except OSError as error:
            tried.append(f"  {place}: {error}")
    raise ImportError("thud's library was not found; THUD_LIBRARY=FILE names it. It was looked for at\n" + "\n".join(tried))


_lib = _load()
_PROGRESS = CFUNCTYPE(c_int, c_void_p, c_double)


class _Error(ctypes.Structure):
    _fields_ = [("status", c_int), ("file", c_char * 512), ("line", c_int), ("column", c_int), ("key", c_char * 128),
                ("what", c_char * 512), ("allowed", c_char * 256)]

class _Moment(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("time_s", c_double), ("ground_mps2", c_double), ("floors", c_size_t), ("contacts", c_size_t),
                *((name, POINTER(c_double)) for name in ("displacement_m", "velocity_mps", "acceleration_mps2",
                                                         "force_n", "indentation_m"))]

_STEP = CFUNCTYPE(c_int, c_void_p, POINTER(_Moment))

class _Control(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("which", c_char_p), ("histories", c_int), ("threads", c_int),
                ("progress", _PROGRESS), ("context", c_void_p), ("step", _STEP)]

class _Table(ctypes.Structure):
    _fields_ = [("columns", c_size_t), ("rows", c_size_t), ("name", POINTER(c_char_p)), ("value", POINTER(c_double))]

class _Force(ctypes.Structure):
    _fields_ = [(name, c_double) for name in ("f0_n", "k_npm", "c_nspm", "K", "p", "D", "r")]


_MEMORY = POINTER(c_double)
_FORCE = CFUNCTYPE(None, c_void_p, c_double, _MEMORY, c_int, POINTER(_Force))
_ENERGY = CFUNCTYPE(c_double, c_void_p, c_double, _MEMORY, c_double)
_ONSET = CFUNCTYPE(None, c_void_p, c_double, c_double, _MEMORY)
_REVERSAL = CFUNCTYPE(None, c_void_p, c_double, c_int, c_double, _MEMORY)
_ULTIMATE = CFUNCTYPE(c_double, c_void_p, c_double, _MEMORY, c_int)

class _Law(ctypes.Structure):
    _fields_ = [("size", c_size_t), ("name", c_char_p), ("context", c_void_p), ("pulls", c_int), ("force", _FORCE),
                ("energy", _ENERGY), ("onset", _ONSET), ("reversal", _REVERSAL), ("ultimate", _ULTIMATE), ("past", _FORCE),
                ("keeps_residual", c_int)]


for _name in ("yaml", "json", "csv", "table_name", "cell", "error_text", "version"):
    getattr(_lib, "thud_" + _name).restype = c_char_p  # the others give a status or nothing
version = _lib.thud_version().decode()


class Error(Exception):
    """What the library says: its text; status, file, line, column, key, what, allowed.

    Where a storey collapsed (status 9), `results` are those up to the collapse; else None.
    """

    results = None

    def __init__(self, error):
        super().__init__(_lib.thud_error_text(byref(error), ctypes.create_string_buffer(1600), ctypes.c_ulong(1600)).decode())
        for name, _ in _Error._fields_:
            value = getattr(error, name)
            setattr(self, name, value.decode() if isinstance(value, bytes) else value)


def _call(function, *arguments):
    error = _Error()
    result = function(*arguments, byref(error))
    if result is None or (isinstance(result, int) and result != 0):
        raise Error(error)
    return result


class Table(dict):
    """Columns by name: arrays of numbers, lists of texts. `t.force` is t["force_n"]; `t["A"]` the rows of structure A."""

    def __getattr__(self, name):
        for column in self:
            if column == name or column.rpartition("_")[0] == name:
                return self[column]
        raise AttributeError(name)

    def __missing__(self, word):
        for texts in self.values():
            if isinstance(texts, list) and word in texts:
                first, count = texts.index(word), texts.count(word)  # rows of a structure stand together
                return Table((name, column[first:first + count]) for name, column in self.items())
        raise KeyError(word)


class Results:
    """Tables as attributes (floors, contacts, impacts, histories; of a sweep sweep, contacts, needed_gaps), and `json`."""

    def __init__(self, handle):
        self._handle = handle
        names = (_lib.thud_table_name(handle, i) for i in range(8))
        self.tables = [name.decode().replace("-", "_") for name in names if name]

    def __del__(self):
        _lib.thud_free(self._handle)

    @property
    def json(self):
        text = _lib.thud_json(self._handle)
        return text.decode() if text else None

    def csv(self, table):
        text = _lib.thud_csv(self._handle, table.replace("_", "-").encode())
        return text.decode() if text else None

    def __getattr__(self, name):
        if name.startswith("_") or name not in self.tables:
            raise AttributeError(name)
        word, table = name.replace("_", "-").encode(), _Table()
        _call(_lib.thud_table, self._handle, word, byref(table))
        columns = Table((table.name[k].decode(), self._column(word, table, k)) for k in range(table.columns))
        setattr(self, name, columns)
        return columns

    def _column(self, word, table, k):
        rows = table.rows
        if _lib.thud_column_kind(self._handle, word, table.name[k]) == 2:  # THUD_KIND_TEXT
            return [_lib.thud_cell(self._handle, word, c_size_t(i), c_size_t(k)).decode() for i in range(rows)]
        values = (c_double * rows).from_address(ctypes.addressof(table.value.contents) + 8 * k * rows)
        values.results = self  # whose memory it is
        return numpy.frombuffer(values) if numpy and rows else memoryview(values).cast("B").cast("d") if rows else []


class Scene:
    """A preset by name, file or (`yaml`) text; None: two neighbours to start from. scene["gap"] = "12 cm"."""

    def __init__(self, preset=None, yaml=None, set=None, **values):
        self._handle, self._kept, self._raised = c_void_p(), [], []
        if yaml is not None:
            text = yaml.encode()
            _call(_lib.thud_parse, text, c_size_t(len(text)), (preset or "scene.yaml").encode(), byref(self._handle))
        else:
            _call(_lib.thud_open, preset.encode() if preset else None, byref(self._handle))
        for key, value in {**(set or {}), **{k.replace("__", ".").replace("_", "-"): v for k, v in values.items()}}.items():
            self[key] = value

    def __del__(self):
        _lib.thud_close(self._handle)

    def __setitem__(self, key, value):
        number = isinstance(value, (int, float))
        function, what = (_lib.thud_set_number, c_double(value)) if number else (_lib.thud_set, value.encode())
        _call(function, self._handle, key.encode(), what)

    def __getitem__(self, key):
        length = c_size_t()
        _call(_lib.thud_get_length, self._handle, key.encode(), byref(length))
        text = ctypes.create_string_buffer(length.value + 1)
        _call(_lib.thud_get, self._handle, key.encode(), text, c_size_t(len(text)))
        return text.value.decode()

    @property
    def yaml(self):
        return _call(_lib.thud_yaml, self._handle).decode()

    def copy(self):
        """Another scene with the same values, ground motion and laws."""
        other = Scene.__new__(Scene)
        other._handle, other._kept, other._raised = c_void_p(), list(self._kept), self._raised
        _call(_lib.thud_copy, self._handle, byref(other._handle))
        return other

    def _guarded(self, function, otherwise=None):
        """What a function raises ends the run that calls it, which raises it; in C it would be lost."""
        def call(*arguments):
            try:
                return function(*arguments)
            except BaseException as problem:
                self._raised.append(problem)
                return otherwise
        return call

    def motion(self, acceleration_mps2, dt_s):
        """The ground's acceleration from any sequence of numbers."""
        values = (c_double * len(acceleration_mps2))(*acceleration_mps2)
        _call(_lib.thud_set_motion, self._handle, values, c_size_t(len(values)), c_double(dt_s))

    def law(self, name, force, energy, interface=1, pulls=False, onset=None, reversal=None, ultimate=None, past=None,
            keeps_residual=False):
        """A contact law: force(mass_kg, restitution) gives a dict of f0_n, k_npm, c_nspm, K, p, D, r; energy(mass_kg, d_m).

        past(mass_kg, restitution) holds beyond ultimate(mass_kg, restitution). With onset(mass_kg, v_mps, memory) or
        reversal(mass_kg, restitution, d_m, memory), which change its eight numbers, every function takes memory last.
        """
        remembers, nan = bool(onset or reversal), float("nan")

        def given(function, otherwise):
            guarded = self._guarded(function, otherwise)
            return lambda *arguments, memory: guarded(*arguments, memory) if remembers else guarded(*arguments)

        def branch(function):
            of = given(function, {"k_npm": nan})

            def put(_context, mass, memory, restitution, out):
                for key, value in of(mass, bool(restitution), memory=memory).items():
                    setattr(out.contents, key, value)
            return _FORCE(self._guarded(put)) if function else _FORCE()
        stored, least = given(energy, nan), given(ultimate, nan)
        begin, turn = self._guarded(onset), self._guarded(reversal)
        law = _Law(ctypes.sizeof(_Law), name.encode(), None, pulls, branch(force),
                   _ENERGY(lambda c, mass, memory, d: stored(mass, d, memory=memory)),
                   _ONSET(lambda c, mass, v, memory: begin(mass, v, memory) and None) if onset else _ONSET(),
                   _REVERSAL(lambda c, mass, r, d, memory: turn(mass, bool(r), d, memory) and None) if reversal else _REVERSAL(),
                   _ULTIMATE(lambda c, mass, memory, r: least(mass, bool(r), memory=memory)) if ultimate else _ULTIMATE(),
                   branch(past), keeps_residual)
        _call(_lib.thud_set_law, self._handle, interface, byref(law))
        self._kept.append(law)

    def _do(self, function, *arguments, which=None, histories=False, threads=0, progress=None, step=None):
        handle = c_void_p()
        told, seen = self._guarded(progress, True), self._guarded(step, True)
        watch = _PROGRESS(lambda _context, part: bool(told(part))) if progress else _PROGRESS()
        show = _STEP(lambda _context, moment: bool(seen(moment.contents))) if step else _STEP()
        control = _Control(ctypes.sizeof(_Control), which.encode() if which else None, histories, threads, watch, None, show)
        self._raised.clear()
        try:
            _call(function, self._handle, *arguments, byref(control), byref(handle))
            failed = None
        except Error as error:
            failed = error
        results = Results(handle) if handle else None
        if self._raised:
            raise self._raised[0]
        if failed:
            failed.results = results
            raise failed
        return results

    def run(self, **how):
        """which="bumper", histories=True, progress=function of the part done that stops by True.

        step=function of each step, with time_s, floors, contacts, displacement_m[0], force_n[0], ...; True ends the run.
        """
        return self._do(_lib.thud_run, **how)

    def sweep(self, vary=None, **how):
        """{"gap": "5cm:25cm:1cm"}, or the scene's own study; which="none,bumper", threads, progress."""
        words = [f"{key}={values}".encode() for key, values in (vary or {}).items()]
        return self._do(_lib.thud_sweep, (c_char_p * (len(words) + 1))(*words) if vary else None, **how)


_HOW = ("which", "histories", "threads", "progress", "step")


def run(preset=None, **named):
    """One scene, one answer: thud.run("towers", gap="12 cm", histories=True).histories.time"""
    how = {name: named.pop(name) for name in _HOW if name in named}
    return Scene(preset, **named).run(**how)


def sweep(preset=None, vary=None, **named):
    """A study's rows as a dict of columns."""
    how = {name: named.pop(name) for name in _HOW if name in named}
    return Scene(preset, **named).sweep(vary, **how).sweep
