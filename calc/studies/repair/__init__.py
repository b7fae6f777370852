# SPDX-License-Identifier: Apache-2.0
"""Where a design fails a limit: the nearest design that passes, and remedies of different kinds, as changes of keys."""
