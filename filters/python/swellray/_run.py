"""Running VTK filters: their errors as exceptions, their warnings as Python's, their progress as a call."""

import warnings

from vtkmodules.vtkCommonCore import VTK_STRING, vtkSMPTools


class Error(RuntimeError):
    """A filter could not do its work; the text is its line, which says what is wrong and what to do."""


class Notice(UserWarning):
    """What a filter has done but wants known: a cap that was reached, a grid too coarse for the wave."""


def set_threads(number):
    """Use so many threads from now on; 0: as many as the machine has."""
    vtkSMPTools.Initialize(int(number))


def _words(message):
    # "ERROR: In file, line n\nvtkClass (0x...): words\n\n"
    head, mark, words = message.partition("): ")
    return (words if mark else head).strip().replace("\n", " ")


def _listener(texts):
    def listen(caller, event, text):
        texts.append(_words(text))

    listen.CallDataType = VTK_STRING
    return listen


def run(algorithm, progress=None, stacklevel=3, work=None):
    """Bring a filter up to date.

    work: what to call in place of its Update()
    progress: called with the share that is done, 0 to 1; what it raises ends the work and is raised here.
    Raises Error with the filter's line; warns with Notice.
    """
    errors, notices, raised = [], [], []

    def advance(caller, event):
        # An exception must not reach VTK, which prints it and goes on, or ends the program at Ctrl-C.
        try:
            if progress is not None and not raised:
                progress(caller.GetProgress())
        except BaseException as exception:
            raised.append(exception)
            caller.AbortExecuteOn()

    executive = algorithm.GetExecutive()
    observers = [
        (algorithm, algorithm.AddObserver("ErrorEvent", _listener(errors))),
        (algorithm, algorithm.AddObserver("WarningEvent", _listener(notices))),
        (algorithm, algorithm.AddObserver("ProgressEvent", advance)),
        (executive, executive.AddObserver("ErrorEvent", _listener(errors))),
    ]
    try:
        (work or algorithm.Update)()
    finally:
        for owner, observer in observers:
            owner.RemoveObserver(observer)
    if raised:
        algorithm.AbortExecuteOff()
        algorithm.Modified()
        raise raised[0]
    for notice in notices:
        warnings.warn(notice, Notice, stacklevel=stacklevel)
    if errors:
        raise Error(errors[0])


def output_of(algorithm, port=0):
    """The output, on its own: running the filter again does not change it."""
    output = algorithm.GetOutputDataObject(port)
    copy = output.NewInstance()
    copy.ShallowCopy(output)
    return copy
