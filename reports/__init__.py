# SPDX-License-Identifier: Apache-2.0
"""Paper: the calculation report and its parts, made from the calculation sheet; nothing here knows a single step."""
