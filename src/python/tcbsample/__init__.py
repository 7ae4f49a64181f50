"""Kochanek-Bartels (TCB) curves through keyframes: samples, fits, comparisons and pictures.

    curve = Curve(keys)          a curve to evaluate, like an interpolator of SciPy: curve(t), curve(t, 1)
    resample(keys, step=0.1)     samples of the curve, as an array or a DataFrame
    fit(samples, 0.01)           a small set of keys whose curve stays within 0.01 of each
    check(keys, samples)         compares samples that another program made with the curve
    identify(keys, samples)      finds the rules by which another program made samples
    limits(keys, {"speed": 2})   the largest speeds, accelerations and the like, against limits
    plot(keys)                   a picture, which a Jupyter cell shows; plot(keys).save("p.png")
    explain(keys, step=0.1)      what was detected in the keys and would be done
    presets()                    the rules of other products, for preset=

help(tcbsample.resample) and the like describe each, and help(tcbsample.Options) lists all options.

Keys have a time, a position of one or more channels, and optionally tension, continuity and bias. Keys and samples are

    a 2-D array           a row for each key; the first column is the time, the others are channels
    (times, positions)    a pair of arrays or sequences; positions of shape (n,) or (n, channels)
    a structured array    a field for each column, as in numpy.array([(0, 1.5)], dtype=[("t", float), ("x", float)])
    a dict of columns     as in {"t": [0, 1], "x": [1.5, 2.5]}; or a list of dicts, one for each key
    a pandas DataFrame    an index of dates or durations is the time, another index with a name is a column, and whole
                          numbers other than 0, 1, 2, ... are the time where no column is; the result is then a
                          DataFrame with the same index, time zone and types
    a pandas Series, an xarray DataArray or Dataset
                          its index, or the coordinate of its first dimension, is the time; the result is a DataFrame
    a path                a str or os.PathLike: a file in any format that the program reads
    an open file, bytes   the contents of such a file

Names of columns have a meaning: t, time, frame and the like are times; tension, continuity, bias, ease_in and ease_out
are parameters of keys; every other column of numbers is a channel. columns= gives other columns these roles. NaN and
None are missing cells, for which missing= says what happens. Dates are in UTC where they have no time zone.

Options are those of the command line, with _ for -; --from is from_. Values are numbers, texts, dates, timedeltas, True
for a flag, lists for values with commas, and dicts for values such as A=B:C. None and False leave an option out. For
example, this is a frame of positions and speeds at 24 frames per second, for each value of the column id:

    resample(frame, fps=24, group="id", fields=["time", "position", "speed"])

A rejected input or a wrong option raises Error, whose members say where and what to do. Notes are warnings of the
class Note. The module runs the program tcbsample, which its wheel contains, and evaluates Curves by NumPy; python -m
tcbsample runs the program itself.
"""

from ._curve import Curve as Curve
from ._functions import Picture as Picture
from ._functions import Preset as Preset
from ._functions import Report as Report
from ._functions import check as check
from ._functions import explain as explain
from ._functions import fit as fit
from ._functions import identify as identify
from ._functions import limits as limits
from ._functions import plot as plot
from ._functions import presets as presets
from ._functions import resample as resample
from ._options import __version__ as __version__
from ._options import Options as Options
from ._program import Error as Error
from ._program import Note as Note
from ._program import program as program
