# SPDX-License-Identifier: Apache-2.0
"""The oil film: Reynolds' equation solved, its stored table, the short bearing in closed form, spring and damper."""
