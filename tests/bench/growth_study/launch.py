"""Runs a command for measuring.py and prints its exit code, processor seconds, kilobytes and seconds on the wall.

In a process of its own, which imports next to nothing: Linux counts the memory of the process that starts a command as
the command's.
"""

import os
import sys
import time

begin = time.monotonic()
child = os.posix_spawn(sys.argv[1], sys.argv[1:], os.environ, file_actions=[(os.POSIX_SPAWN_DUP2, 2, 1)])
_, status, usage = os.wait4(child, 0)
print(os.waitstatus_to_exitcode(status), usage.ru_utime + usage.ru_stime, usage.ru_maxrss, time.monotonic() - begin)
