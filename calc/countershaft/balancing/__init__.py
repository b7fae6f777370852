# SPDX-License-Identifier: Apache-2.0
"""The sheet for the balancing machine: what the shaft is meant to be out of balance, and what is drilled where."""
