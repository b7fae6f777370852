# SPDX-License-Identifier: Apache-2.0
"""What a report says, part by part, as blocks that `typesetting/pagination.py` sets on pages."""
