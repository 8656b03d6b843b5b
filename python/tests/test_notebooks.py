# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Every notebook of docs/notebooks runs from its first cell to its last, in a kernel of its own; its cells assert what they show."""
import importlib.util
import os
from pathlib import Path

import pytest

FOLDER = Path(__file__).parent.parent.parent / "docs" / "notebooks"
NEEDS = {"training": ["gymnasium", "mujoco"], "sweeps": ["pyarrow", "cloudpickle"]}


@pytest.mark.parametrize("path", sorted(FOLDER.glob("*.py")), ids=lambda path: path.stem)
def test_notebook(path, tmp_path):
    for module in ["jupytext", "nbclient", "ipykernel", *NEEDS.get(path.stem, [])]:
        if importlib.util.find_spec(module) is None:
            pytest.skip(f"{module} is not installed")
    import jupytext
    import nbclient
    notebook = jupytext.read(path)
    assert [cell.cell_type for cell in notebook.cells].count("markdown") >= 1
    nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": str(tmp_path)}}).execute()
    assert all(output.output_type != "error" for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs)


def test_every_notebook_is_on_its_page():
    page = (FOLDER / "README.md").read_text()
    names = {path.name for path in FOLDER.glob("*.py")}
    assert len(names) >= 5 and all(f"({name})" in page for name in names)
    assert os.path.isfile(FOLDER.parent / "python" / "index.md") and "notebooks" in (FOLDER.parent / "python" / "index.md").read_text()
