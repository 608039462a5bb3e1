"""The program `machinist`: the same commands as the program built by Cargo, without Symbolica."""

from __future__ import annotations

import signal
import sys


def main() -> None:
    """Run the command of this process's arguments, and exit with its code."""
    from machinist import _machinist

    # The commands have handlers of their own; Python's would run only after them.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    # Not `-m machinist`, which would find a folder of that name where the command runs.
    again = (sys.executable, [__file__])
    sys.exit(_machinist.program(again, sys.argv[1:]))


if __name__ == "__main__":
    main()
