# SPDX-License-Identifier: Apache-2.0
"""The whole drive by one command: every combination of shaft, bearings and making that passes, and the front of what
they trade.

The flow: `problem` says what is varied and what must hold; `films`, `shafts` and `combine` make the front of one class
on arrays; `run` does the classes, over processes where asked; `whole` solves rows as the program solves any design, and
only these are shown; where nothing passes, `relax` says which requirement would have to give way."""
