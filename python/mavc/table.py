"""Tables: columns as numpy arrays, and as Arrow, pandas and Polars."""

from __future__ import annotations

import csv
import importlib
import io
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Iterable, Iterator, Sequence

import numpy as np

from . import _mavc

if TYPE_CHECKING:
    import pandas
    import polars
    import pyarrow


def module(name: str, why: str) -> Any:
    """An optional package.

    Raises ImportError with what to install if it is missing.
    """
    try:
        return importlib.import_module(name)
    except ImportError as error:
        package = name.split(".")[0]
        raise ImportError(f"{why} needs {package}: pip install {package}", name=package) from error


class Table(Mapping[str, np.ndarray]):
    """Named columns of one length. A missing number is NaN, a missing text or truth value None; in Arrow both are null.

    Any library that reads the Arrow C stream interface takes a table as it is: `polars.DataFrame(table)`,
    `duckdb.from_arrow(table)`.
    """

    def __init__(self, columns: Mapping[str, np.ndarray], csv: str) -> None:
        self._columns = dict(columns)
        self.csv = csv
        """The table as the command writes it, byte for byte."""

    def __getitem__(self, name: str) -> np.ndarray:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        """The number of columns, as of every mapping; `rows` is the number of rows."""
        return len(self._columns)

    @property
    def rows(self) -> int:
        return len(next(iter(self._columns.values()), ()))

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {self.rows} rows, {len(self)} columns>"

    def to_arrow(self) -> pyarrow.Table:
        """The table as a `pyarrow.Table`."""
        pa = module("pyarrow", "an Arrow table")
        return pa.table({name: self._arrow(pa, column) for name, column in self._columns.items()})

    def _arrow(self, pa: Any, column: np.ndarray) -> Any:
        return pa.array(column, from_pandas=True)

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        return self.to_arrow().__arrow_c_stream__(requested_schema)

    def to_pandas(self) -> pandas.DataFrame:
        """The table as a pandas frame."""
        module("pandas", "a pandas frame")
        return self.to_arrow().to_pandas()

    def to_polars(self) -> polars.DataFrame:
        """The table as a Polars frame."""
        frame: polars.DataFrame = module("polars", "a Polars frame").from_arrow(self.to_arrow())
        return frame

    def to_parquet(self, path: Any) -> None:
        """Writes the table as Parquet."""
        arrow = self.to_arrow()
        module("pyarrow.parquet", "a Parquet file").write_table(arrow, path)


def numbers(csv: str) -> dict[str, np.ndarray]:
    """The columns of a table of numbers, exactly as written."""
    return {name: np.frombuffer(data, dtype=np.float64) for name, data in _mavc.columns(csv)}


class Records(Table):
    """One row for each record; the columns have the same types whatever the records hold."""

    def __init__(self, kinds: Mapping[str, type], records: Iterable[Mapping[str, Any]]) -> None:
        rows = [{name: record.get(name) for name in kinds} for record in records]
        text = io.StringIO()
        writer = csv.DictWriter(text, list(kinds), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
        self._kinds = dict(kinds)
        columns = {name: self._column(kind, [row[name] for row in rows]) for name, kind in kinds.items()}
        super().__init__(columns, text.getvalue())

    def _column(self, kind: type, values: list[Any]) -> np.ndarray:
        if kind is float:
            return np.array([np.nan if value is None else value for value in values], dtype=float)
        return np.array(values, dtype=np.int64 if kind is int else object)

    def to_arrow(self) -> pyarrow.Table:
        pa = module("pyarrow", "an Arrow table")
        types = {float: pa.float64(), int: pa.int64(), str: pa.string(), bool: pa.bool_()}
        columns = {name: pa.array(self[name], types[kind], from_pandas=True) for name, kind in self._kinds.items()}
        return pa.table(columns)


class Rows(Table):
    """The rows of a campaign, one for each flight (docs/campaigns.md describes the columns)."""

    _TEXTS = ("campaign", "planner", "mode", "outcome", "cause", "limits_broken", "checksum")
    _COUNTS = ("cases", "case", "seed", "turns", "false_alarms", "refused")
    _MISSING_COUNTS = ("waypoints_due", "waypoints_missed")

    def __init__(self, csv: str) -> None:
        lines = csv.splitlines()
        names = lines[0].split(",")
        cells = [line.split(",") for line in lines[1:]]
        columns = list(zip(*cells)) if cells else [()] * len(names)
        super().__init__({name: self._column(name, column) for name, column in zip(names, columns)}, csv)

    def _column(self, name: str, cells: Sequence[str]) -> np.ndarray:
        if name in self._TEXTS:
            return np.array([cell or None for cell in cells], dtype=object)
        if name == "heading_broken":
            return np.array([{"": None, "true": True, "false": False}[cell] for cell in cells], dtype=object)
        if name in self._COUNTS:
            return np.array([int(cell) for cell in cells], dtype=np.int64)
        return np.array([float(cell) if cell else np.nan for cell in cells])

    def to_arrow(self) -> pyarrow.Table:
        pa = module("pyarrow", "an Arrow table")
        reader = module("pyarrow.csv", "an Arrow table")
        kinds = {name: pa.float64() for name in self}
        kinds.update({name: pa.string() for name in self._TEXTS})
        kinds.update({name: pa.int64() for name in self._COUNTS + self._MISSING_COUNTS})
        kinds["heading_broken"] = pa.bool_()
        options = reader.ConvertOptions(column_types=kinds, null_values=[""], strings_can_be_null=True)
        return reader.read_csv(io.BytesIO(self.csv.encode()), convert_options=options)
