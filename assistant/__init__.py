# SPDX-License-Identifier: Apache-2.0
"""The program as people use it: the command line, the guided session in a terminal or a browser.

`cli.py` finds the command and `commands/` runs it; `actions.py` has every key of the session, `session/` the design
under edit without a screen, `screens/` and `widgets/` what is seen."""
