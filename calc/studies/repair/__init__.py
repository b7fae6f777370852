# SPDX-License-Identifier: Apache-2.0
"""Where a design fails a limit: the nearest design that passes, found by the choosers, solved whole, and said as
changes of keys."""
