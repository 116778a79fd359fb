"""The program: ``mixity``, or ``python -m mixity``, with the commands of ``mixity help``. ``mixity explorer`` opens the page that
fits and draws in the browser; it is part of this package."""

import pathlib
import signal
import sys
import webbrowser


def open_explorer() -> int:
    page = pathlib.Path(__file__).with_name("explorer.html").resolve()
    print(page)
    if not webbrowser.open(page.as_uri()):
        print("no browser was found: open this file in one", file=sys.stderr)
    return 0


def main(words: list[str]) -> int:
    if words == ["explorer"]:
        return open_explorer()
    from . import _core

    # as for any program: Ctrl-C ends it, and so does a reader that has read enough
    for name in ("SIGINT", "SIGPIPE"):
        signal.signal(getattr(signal, name), signal.SIG_DFL)
    sys.stdout.flush()
    return _core.program(words)


def program() -> None:
    sys.exit(main(sys.argv[1:]))


if __name__ == "__main__":
    program()
