# SPDX-License-Identifier: Apache-2.0
"""Pages made into a document that can be kept: files inside it, PDF/A, running heads."""
