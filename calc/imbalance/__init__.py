# SPDX-License-Identifier: Apache-2.0
"""Forces and couples of every order, forward and backward."""
