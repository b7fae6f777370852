# SPDX-License-Identifier: Apache-2.0
"""A design: its inputs, its file, the keys of both, what guards them, and the replay of scripted edits.

`step_inputs.py` is what one step hands to another, `key_results.py` what stands first in a report."""
