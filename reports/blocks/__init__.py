# SPDX-License-Identifier: Apache-2.0
"""What a report says, part by part, as blocks that the flow sets on pages."""
