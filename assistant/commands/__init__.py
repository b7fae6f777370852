# SPDX-License-Identifier: Apache-2.0
"""The commands of the command line, a few to a file: each is `run_…(arguments) -> exit code`."""
