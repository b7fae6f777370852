# SPDX-License-Identifier: Apache-2.0
"""Four ways from a bearing and its duty to the film: oil supply, friction and flow, and the thermal balance that closes
them."""
