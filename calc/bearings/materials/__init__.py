# SPDX-License-Identifier: Apache-2.0
"""Journal and seat as a pair: what the journal may run on, what is usual, what runs already."""
