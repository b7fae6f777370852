# SPDX-License-Identifier: Apache-2.0
"""The whole drive by one command: every combination of shaft, bearings and making that passes, and their front.

The flow: `problem` says what is varied and what must hold; `films`, `shafts` and `combinations` make the front of one
class on arrays; `search` does the classes, over processes where asked; `solved_drive` solves rows as the program solves
any design, and only these are shown; where nothing passes, `refusal` says which requirement would have to give way."""
