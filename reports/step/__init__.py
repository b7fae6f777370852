# SPDX-License-Identifier: Apache-2.0
"""Parts as solids in a STEP file (ISO 10303-21, AP214), by the extra `cad`; lengths in millimetres."""
