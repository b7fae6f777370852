# SPDX-License-Identifier: Apache-2.0
"""What the making and mounting of the shaft asks: unbalance, holes, scatter, bolts, support, oil drain, cost."""
