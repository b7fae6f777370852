# SPDX-License-Identifier: Apache-2.0
"""The report as a Word document, for those who go on writing."""
