# SPDX-License-Identifier: Apache-2.0
"""The outline of a tooth as its tool makes it, two wheels in mesh, and the drawing of both."""
