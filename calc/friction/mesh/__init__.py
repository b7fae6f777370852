# SPDX-License-Identifier: Apache-2.0
"""One mesh: the line of action, the film along it, its friction and temperatures, the power it loses."""
