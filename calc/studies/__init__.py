# SPDX-License-Identifier: Apache-2.0
"""What is asked of whole designs: comparing, explaining, sweeping, searching, repairing, beginning."""
