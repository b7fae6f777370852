# SPDX-License-Identifier: Apache-2.0
"""What a design gives to other programs and to the shop: a table of the kinds of files (`kinds.py`), and a module for
each that makes it.  The command line and the session read the same table."""
