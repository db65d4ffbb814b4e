"""Frames as ParaView's own library reads them: arrays, names of walls, ids that stay when particles enter and leave.

usage: frames.py DEMENS TOML; exit 77 where vtk is missing (Debian: python3-vtk9).
"""
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

try:
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError:
    print("skipped: no vtk")
    sys.exit(77)

demens, toml = (os.path.abspath(name) for name in sys.argv[1:3])


def read(file):
    reader = vtkXMLPolyDataReader()
    assert reader.CanReadFile(file), file
    reader.SetFileName(file)
    reader.Update()
    assert reader.GetErrorCode() == 0, file
    return reader.GetOutput()


def numbers(attributes, name):
    array = attributes.GetArray(name)
    assert array is not None, name
    return vtk_to_numpy(array)


def words(data, name):
    array = data.GetFieldData().GetAbstractArray(name)
    assert array is not None, name
    return [array.GetValue(k) for k in range(array.GetNumberOfValues())]


with tempfile.TemporaryDirectory() as folder:
    subprocess.run([demens, "try", toml, "--frames", folder, "--frame-interval", "0.02"], check=True, cwd=folder,
                   stdout=subprocess.DEVNULL)
    folder = os.path.join(folder, next((name for name in os.listdir(folder) if os.path.isdir(os.path.join(folder, name))), ""))
    seen = []
    for which in ("particles", "walls"):
        entries = list(xml.etree.ElementTree.parse(os.path.join(folder, which + ".pvd")).iter("DataSet"))
        assert len(entries) > 10
        for entry in entries:
            data = read(os.path.join(folder, entry.get("file")))
            time = data.GetFieldData().GetArray("TimeValue").GetValue(0)
            assert abs(time - float(entry.get("timestep"))) < 1e-9
            if which == "walls":
                names, of_faces = words(data, "wall_names"), numbers(data.GetCellData(), "wall")
                assert data.GetNumberOfCells() == len(of_faces) > 1
                assert {names[k] for k in of_faces} == {"chute", "tube"}, names
                continue
            points = data.GetPointData()
            ids, groups = numbers(points, "id"), numbers(points, "group")
            assert data.GetNumberOfPoints() == data.GetNumberOfVerts() == len(ids) == len(set(ids))
            assert words(data, "group_names") == ["rain"] and words(data, "material_names") == ["glass", "steel"]
            assert set(groups) <= {0} and set(numbers(points, "material")) <= {0}
            for name, components in (("radius", 1), ("mass", 1), ("velocity", 3), ("force", 3), ("contacts", 1)):
                assert points.GetArray(name).GetNumberOfComponents() == components
                assert len(numbers(points, name)) == len(ids)
            seen.append(dict(zip(ids, numbers(points, "radius"))))
    # Batches enter and leave; an id is always the same sphere, and none that is gone comes back.
    radii = {}
    gone = set()
    for before, now in zip(seen, seen[1:]):
        gone |= set(before) - set(now)
        assert not gone & set(now)
        assert all(radii.setdefault(k, r) == r for k, r in now.items())
    assert len(gone) >= 20 and max(radii) == 39 and len(set(radii.values())) >= 5, (len(gone), max(radii))
    print(f"{len(seen)} frames, {len(radii)} particles, of which {len(gone)} left")
