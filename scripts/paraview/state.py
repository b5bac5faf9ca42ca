"""A series of ogive in ParaView: the section through plate and projectile, coloured by plastic strain.

    pvpython scripts/paraview/state.py vtk_out/CASE/perforation.pvd picture.png    # a picture of the last frame

or inside ParaView by File > Load State; then the series is the one that the environment variable OGIVE_PVD names.
Positions are in mm, times in us. Particles are spheres as wide as their distance.
"""
import os
import sys

from paraview import simple as pv

FIELD = "plastic_strain"
LARGEST = 1.5


def parts_of(series):
    """(name, diameter in mm or None, whether only positive x and y were computed) of each part, from the file."""
    data = pv.servermanager.Fetch(series)
    for k in range(data.GetNumberOfBlocks()):
        leaf = data.GetBlock(k)
        while leaf.IsA("vtkMultiBlockDataSet"):
            leaf = leaf.GetBlock(0)
        fields = leaf.GetFieldData()
        diameter, planes = fields.GetArray("particle_diameter_mm"), fields.GetArray("symmetry_planes")
        mirrored = [planes is not None and planes.GetComponent(0, axis) != 0 for axis in (0, 1)]
        yield (data.GetMetaData(k).Get(data.NAME()), diameter.GetComponent(0, 0) if diameter else None, *mirrored)


def section_of(series, name, mirrored_x, mirrored_y):
    """The half of a part behind the plane y = 0."""
    part = pv.ExtractBlock(registrationName=name, Input=series, Selectors=[f"/Root/{name}"])
    if mirrored_x:
        part = pv.Reflect(registrationName=f"{name}, both sides", Input=part, Plane="X", Center=0.0)
    if not mirrored_y:
        part = pv.Clip(registrationName=f"{name}, cut", Input=part, ClipType="Plane", Crinkleclip=1, Invert=0)
        part.ClipType.Origin, part.ClipType.Normal = [0, 0, 0], [0, 1, 0]
    return part


def show(part, view, diameter):
    display = pv.Show(part, view)
    display.SetRepresentationType("Point Gaussian" if diameter else "Surface With Edges")
    if diameter:
        display.GaussianRadius = diameter / 2
    pv.ColorBy(display, ("POINTS" if diameter else "CELLS", FIELD))
    return display


def show_section(pvd):
    """Draws the last frame of a series and gives the view."""
    name = os.path.basename(os.path.dirname(os.path.abspath(pvd)))
    series = pv.PVDReader(registrationName=name, FileName=pvd)
    view = pv.GetActiveViewOrCreate("RenderView")
    view.ViewSize = [1200, 1000]
    pv.LoadPalette("WhiteBackground")
    times = pv.GetAnimationScene()
    times.UpdateAnimationUsingDataTimeSteps()
    times.GoToLast()
    series.UpdatePipeline(times.AnimationTime)

    for part, diameter, mirrored_x, mirrored_y in list(parts_of(series)):
        display = show(section_of(series, part, mirrored_x, mirrored_y), view, diameter)
    pv.GetColorTransferFunction(FIELD).RescaleTransferFunction(0.0, LARGEST)
    display.SetScalarBarVisibility(view, True)

    view.CameraParallelProjection = 1
    view.CameraViewUp = [0, 0, 1]
    view.CameraFocalPoint, view.CameraPosition = [0, 0, -8], [0, -300, -8]
    view.CameraParallelScale = 35
    view.OrientationAxesVisibility = 0
    return view


def main():
    pvd = sys.argv[1] if len(sys.argv) > 1 else os.environ.get("OGIVE_PVD")
    if not pvd or not os.path.isfile(pvd):
        sys.exit(f"state.py: error: {pvd or 'no series'}: give a perforation.pvd, as an argument or by OGIVE_PVD")
    view = show_section(pvd)
    if len(sys.argv) > 2:
        pv.SaveScreenshot(sys.argv[2], view)


main()
