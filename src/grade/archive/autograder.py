#!/usr/bin/env python3
"""Marks the ray trees in the current folder: writes result.json and release-body.md."""
import os
import pathlib
import subprocess
import sys

bundle = pathlib.Path(os.environ.get("CLASSROOM50_BUNDLE_DIR") or pathlib.Path(__file__).resolve().parent)
raytree = bundle / "raytree"
raytree.chmod(0o755)
os.environ.setdefault("OWNER", os.environ.get("USERNAME", ""))
command = [raytree, "grade", bundle / TASK, ".", "--student"]
command += ["--output", "classroom50=result.json", "--output", "text=raytree.txt"]
status = subprocess.run(command).returncode
if status != 0:
    sys.exit(status)
told = pathlib.Path("raytree.txt")
lines = told.read_text(encoding="utf-8").splitlines()
told.unlink()
indented = "".join(f"    {line}\n" for line in lines)
pathlib.Path("release-body.md").write_text(f"### Marks by raytree\n\n{indented}", encoding="utf-8")
