# SPDX-License-Identifier: Apache-2.0
"""How large, how deep and how long at most: what the program reads, computes and waits for.  SECURITY.md prints these
tables."""

from ..measurements.inputs import BYTES, NODES
from ..measurements.inputs import ROWS as ROWS_OF_RUN
from ..sheet.errors import SHOWN_ERRORS
from ..sheet.toml_scan import DEPTH, ENTRIES

# --- a design or a replay: it has a few thousand bytes and a few hundred entries

DESIGN_BYTES = 2**20
DESIGN_ENTRIES, DESIGN_DEPTH = ENTRIES, DEPTH
REPLAY_STEPS, REPLAY_REPORTS = 1000, 20  # each solves a design; a report takes as long as ten of them


# --- what a report takes in

PDF_BYTES = 32 * 2**20
PDF_UNPACKED = 256 * 2**20
APPENDED_SECONDS, APPENDED_MEMORY = 90, 2**31  # of the process that compares it
LOGO_BYTES = 300_000
LOGO_SIDE = 2000
FRONT_BYTES = 4_000_000  # a front of 2000 drives has a third of it
PART_BYTES = 2**28  # of a class that a search has kept

# --- the designs of a sweep that stand in a file

LIST_BYTES = 16 * 2**20
LIST_ROWS, LIST_COLUMNS = 100_000, 100
CHUNK_BYTES = 2**26  # that a sweep has kept; one with every value has 2 MB


# --- the session in a browser

HOST = "127.0.0.1"  # of the pages of `serve`: this machine alone
SESSIONS = 8
COLUMNS, ROWS = 1000, 500
PASTED = 100_000
MESSAGE_BYTES = 2**20


# --- patience, in seconds

LOCK_SECONDS = 10
SEARCH_SECONDS = 5

TABLES: dict[str, dict[str, int]] = {
    "a design or a replay": {
        "bytes, of a regular file": DESIGN_BYTES,
        "entries: values, elements of lists and headers": DESIGN_ENTRIES,
        "tables in tables": DESIGN_DEPTH,
        "steps of a replay, each of which solves a design": REPLAY_STEPS,
        "of which write a report": REPLAY_REPORTS,
        "mistakes that are printed; the rest are counted": SHOWN_ERRORS,
    },
    "a PDF": {
        "bytes, of a regular file": PDF_BYTES,
        "bytes of all its streams, unpacked": PDF_UNPACKED,
        "seconds to compare what was appended to a report, in a process of its own": APPENDED_SECONDS,
        "bytes of memory of that process": APPENDED_MEMORY,
    },
    "what stands beside a design": {
        "bytes of a logo": LOGO_BYTES,
        "pixels of a logo, either way": LOGO_SIDE,
        "bytes of a front": FRONT_BYTES,
        "bytes of the file of a run": BYTES,
        "rows of it": ROWS_OF_RUN,
        "nodes, at each of which the design is solved": NODES,
    },
    "a table of designs (`sweep --list`)": {
        "bytes, of a regular file": LIST_BYTES,
        "designs": LIST_ROWS,
        "inputs that it varies": LIST_COLUMNS,
    },
    "`serve`": {
        "sessions at a time": SESSIONS,
        "columns of a terminal": COLUMNS,
        "rows of a terminal": ROWS,
        "letters pasted at once": PASTED,
        "bytes of a message": MESSAGE_BYTES,
    },
    "time, in seconds": {
        "to wait for another writer in the same folder": LOCK_SECONDS,
        "of computing, to search for what would make a design pass (`check`)": SEARCH_SECONDS,
    },
}
