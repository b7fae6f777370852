# SPDX-License-Identifier: Apache-2.0
"""`python -m assistant` is `contralbero`."""

import sys

from .cli import main

sys.exit(main())
