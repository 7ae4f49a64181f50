"""Options of the command line that functions of this module do not take, and what there is instead."""

_RETURNED = "results are returned, not written"
_ONE_INPUT = "call the function for each file, or run the command tcbsample"
_OTHER_FUNCTION = "call the function of this name"
_NO_TERMINAL = "nothing is printed"

COMMAND_ONLY = {
    "output": _RETURNED,
    "output_format": _RETURNED,
    "no_output_header": _RETURNED,
    "output_delimiter": _RETURNED,
    "output_decimal": _RETURNED,
    "hex": _RETURNED,
    "meta": _RETURNED,
    "output_dir": _ONE_INPUT,
    "files": _ONE_INPUT,
    "null": _ONE_INPUT,
    "recursive": _ONE_INPUT,
    "suffix": _ONE_INPUT,
    "update": _ONE_INPUT,
    "color": _NO_TERMINAL,
    "check": _OTHER_FUNCTION,
    "identify": _OTHER_FUNCTION,
    "limits": _OTHER_FUNCTION,
    "retime": "run the command tcbsample, which reads the keys twice",
    "fit": _OTHER_FUNCTION,
    "plot": _OTHER_FUNCTION,
    "explain": _OTHER_FUNCTION,
    "list_presets": "call presets()",
    "version": "see tcbsample.__version__",
    "help": "see help(tcbsample.Options)",
    "generate": "run the command tcbsample",
}

# How messages name the options for which there is something else.
PRODUCTS = {
    **{name: f"{name}()" for name, instead in COMMAND_ONLY.items() if instead is _OTHER_FUNCTION},
    "list_presets": "presets()",
    "help": "help(tcbsample.Options)",
}
