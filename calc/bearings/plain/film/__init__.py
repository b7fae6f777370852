# SPDX-License-Identifier: Apache-2.0
"""The oil film: Reynolds' equation solved, also with grooves; its stored table, the short bearing, spring and
damper."""
