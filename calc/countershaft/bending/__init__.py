# SPDX-License-Identifier: Apache-2.0
"""The shaft bent under its own centrifugal load: slopes, natural frequency, stresses."""
