# SPDX-License-Identifier: Apache-2.0
"""The counter-rotating shaft: what it supplies, what its supports carry."""
