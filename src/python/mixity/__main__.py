"""``python -m mixity explorer`` opens the page that fits and draws in the browser; it is part of this package."""

import pathlib
import sys
import webbrowser

USAGE = """usage: python -m mixity explorer    opens the page that fits and draws in the browser
       python -m mixity --version"""


def main(words: list[str]) -> int:
    if words == ["explorer"]:
        page = pathlib.Path(__file__).with_name("explorer.html").resolve()
        print(page)
        if not webbrowser.open(page.as_uri()):
            print("no browser was found: open this file in one", file=sys.stderr)
        return 0
    if words == ["--version"]:
        from . import __version__

        print("mixity", __version__)
        return 0
    print(USAGE, file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
