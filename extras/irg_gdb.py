# SPDX-License-Identifier: MIT
"""How gdb shows irg's values: `source extras/irg_gdb.py`, or from ~/.gdbinit.

  vec, point    (1, 2, 3)
  hpoint        (2 : 4 : 6 : 2)
  plane         1 x + 2 y + 3 z + 4 = 0
  mat           2 rows of 3: [[1, 2, 3], [4, 5, 6]]
  image         640 x 480 pixels; of a view also how far apart its rows are
"""
import re

import gdb

TYPE = re.compile(r"^(?:const )?irg::(vec|point|hpoint|plane|mat|image_view|image)<(.*)>$")


def coordinates(value, names):
    return [str(value[name]) for name in names]


def members(value):
    return [field.name for field in value.type.strip_typedefs().fields() if not field.is_base_class and not field.artificial]


class Printer:
    def __init__(self, kind, value):
        self.kind = kind
        self.value = value

    def to_string(self):
        value = self.value
        if self.kind in ("vec", "point"):
            return "(" + ", ".join(coordinates(value, members(value))) + ")"
        if self.kind == "hpoint":
            return "(" + " : ".join(coordinates(value, members(value))) + ")"
        if self.kind == "plane":
            a, b, c, d = coordinates(value, "abcd")
            return f"{a} x + {b} y + {c} z + {d} = 0"
        if self.kind == "mat":
            entries = value["m"]
            rows = entries.type.range()[1] + 1
            columns = entries[0].type.range()[1] + 1
            text = ", ".join("[" + ", ".join(str(entries[r][c]) for c in range(columns)) + "]" for r in range(rows))
            return f"{rows} rows of {columns}: [{text}]"
        text = f"{value['width_']} x {value['height_']} pixels"
        return text + (f", rows {value['stride_']} bytes apart" if self.kind == "image_view" else "")


def printer_of(value):
    found = TYPE.match(str(value.type.strip_typedefs().unqualified()))
    return Printer(found.group(1), value) if found else None


gdb.pretty_printers.append(printer_of)
