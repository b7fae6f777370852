# SPDX-License-Identifier: Apache-2.0
"""Published models of tooth friction beside that of this program, each with its range."""
