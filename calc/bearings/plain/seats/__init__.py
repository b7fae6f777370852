# SPDX-License-Identifier: Apache-2.0
"""What the journal runs in: the housing itself, a pressed bush, half shells; how they sit, over temperature too."""
