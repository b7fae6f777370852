# SPDX-License-Identifier: Apache-2.0
"""The engine on its mounts: what the driver, the frame and the engine itself feel, without and with the shaft."""
