# SPDX-License-Identifier: Apache-2.0
"""The version as a literal: reading it from the installed metadata would cost 50 ms."""

VERSION = "0.2.0"
