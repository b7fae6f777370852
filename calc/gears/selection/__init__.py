# SPDX-License-Identifier: Apache-2.0
"""Profile shifts that balance the specific sliding of the whole train, tip cuts, and idlers to choose from."""
