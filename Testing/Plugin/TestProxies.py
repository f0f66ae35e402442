# SPDX-License-Identifier: BSD-3-Clause
"""Each proxy of the plugin says what its class says: names, defaults, ranges, ports, documentation;
and has what a panel needs: help, icon, groups, names of outputs, places in File > Open and Save."""
import glob
import os
import re
import xml.etree.ElementTree as ElementTree

import featurehex
from paraview import servermanager, simple
from vtkmodules.vtkCommonCore import reference
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm, vtkPolyDataAlgorithm

# Larger limits keep numbers finite and mean nothing to users: the panel has none.
UNLIMITED = 1e9
RESOURCES = os.path.join(os.environ["FEATUREHEX_SOURCE_DIR"], "Plugin", "Resources")

ICONS = [e.get("alias") for e in ElementTree.parse(
    os.path.join(RESOURCES, "icons.qrc")).iter("file")]
assert sorted(ICONS) == sorted(os.path.basename(path) for path in glob.glob(
    os.path.join(RESOURCES, "Icons", "*.svg"))), ICONS

simple.LoadPlugin(os.environ["FEATUREHEX_PLUGIN"])
manager = servermanager.ProxyManager()


def properties_of(instance):
    """Names of all Set/Get pairs of the class itself."""
    own = set(dir(instance)) - set(dir(vtkPolyDataAlgorithm())) - set(dir(vtkAlgorithm()))
    return {name[3:] for name in own if name.startswith("Set") and "Get" + name[3:] in own}


def clamp_of(instance, name, value):
    """What the class makes of a value far outside."""
    setter, getter = getattr(instance, "Set" + name), getattr(instance, "Get" + name)
    before = getter()
    setter(value)
    result = getter()
    setter(before)
    return result


def limits_of(domain):
    limits = []
    for get, exists in ((domain.GetMinimum, domain.GetMinimumExists),
                        (domain.GetMaximum, domain.GetMaximumExists)):
        limits.append(get(0, reference(0)) if exists(0) else None)
    return limits


def documented(item, where):
    documentation = item.GetDocumentation()
    text = documentation.GetDescription() if documentation else None
    assert text and len(text.split()) >= 3, f"{where}: no documentation"


def check_range(instance, name, smproperty, where):
    default = getattr(instance, "Get" + name)()
    if isinstance(default, str):
        assert smproperty.GetDomain("array_list"), f"{where}: no domain"
        return
    kinds = [smproperty.GetDomain(key) for key in ("bool", "enum", "range")]
    assert any(kinds), f"{where}: no domain"
    boolean, enumeration, limited = kinds
    if boolean:
        assert isinstance(default, bool), where
        return
    far = 1e300 if isinstance(default, float) else 2**31 - 1
    low, high = clamp_of(instance, name, -far), clamp_of(instance, name, far)
    if enumeration:
        values = [enumeration.GetEntryValue(i) for i in range(enumeration.GetNumberOfEntries())]
        assert values == list(range(low, high + 1)), f"{where}: {values}, in C++ {low} to {high}"
        for i in range(enumeration.GetNumberOfEntries()):
            text = enumeration.GetEntryText(i)
            getattr(instance, f"Set{name}To{text}")()
            assert getattr(instance, "Get" + name)() == values[i], f"{where}: {text}"
        getattr(instance, "Set" + name)(default)
        return
    wanted = [low, high if high < UNLIMITED else None]
    assert limits_of(limited) == wanted, f"{where}: {limits_of(limited)}, in C++ {wanted}"


def check_default(instance, name, value, where):
    default = getattr(instance, "Get" + name)()
    assert value == default, f"{where}: {value} in the panel, {default} in C++"


def check_groups(definition, where):
    """Panels of more than three properties have groups, and each property is in just one."""
    grouped = [e.get("name") for e in definition.findall("PropertyGroup/Property")]
    own = [e.get("name") for e in definition if "Vector" in e.tag and e.get("name") != "FileName"]
    assert len(set(grouped)) == len(grouped) and set(grouped) <= set(own), f"{where}: {grouped}"
    if grouped or len(own) > 3:
        assert set(grouped) == set(own), f"{where}: in no group: {set(own) - set(grouped)}"
    for element in definition.findall("PropertyGroup"):
        assert element.get("label"), where


def check_menu(definition, where):
    menu = definition.find("Hints/ShowInMenu")
    assert menu.get("category") == "FeatureHex", where
    icon = definition.get("name") + ".svg"
    assert menu.get("icon") == ":/FeatureHex/" + icon and icon in ICONS, where
    ports = definition.findall("OutputPort")
    assert [int(e.get("index")) for e in ports] == list(range(len(ports))), where
    assert ports and all(e.get("name") for e in ports), f"{where}: outputs without names"
    # Only the first output is shown by itself: the others would hide it. Sharp features don't.
    hidden = [int(e.get("port")) for e in definition.findall("Hints/View[@type='None']")]
    wanted = [] if definition.get("name") == "SurfaceFeature" else list(range(1, len(ports)))
    assert hidden == wanted, f"{where}: {hidden}"


def check_writer(definition, where):
    """In File > Save Data; all it writes and asks is documented."""
    factory = definition.find("Hints/WriterFactory")
    assert factory.get("extensions") and factory.get("file_description"), where
    documentation = definition.find("Documentation")
    assert documentation.get("short_help") and documentation.get("long_help"), where
    for element in definition:
        if "Property" in element.tag:
            assert element.find("Documentation") is not None, f"{where} {element.get('name')}"


def check_proxy(group, definition):
    name = definition.get("name")
    where = f"{group}/{name}"
    proxy = manager.NewProxy(group, name)
    assert proxy, where
    proxy.UpdateVTKObjects()
    documented(proxy, where)
    for kind in ("GetShortHelp", "GetLongHelp"):
        assert getattr(proxy.GetDocumentation(), kind)(), f"{where}: {kind}"

    cls = definition.get("class")
    instance = getattr(featurehex, cls)()
    words = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", re.sub("^vtk|Filter$", "", cls))
    assert proxy.GetXMLLabel() == words and name == words.replace(" ", ""), where

    names, basic = set(), 0
    iterator = proxy.NewPropertyIterator()
    iterator.Begin()
    while not iterator.IsAtEnd():
        key, smproperty = iterator.GetKey(), iterator.GetProperty()
        iterator.Next()
        here = f"{where}.{key}"
        documented(smproperty, here)
        if smproperty.IsA("vtkSMInputProperty") or key == "FileName":
            continue
        names.add(key)
        element = next(e for e in definition if e.get("name") == key and "Vector" in e.tag)
        check_default(instance, key, type(getattr(instance, "Get" + key)())(
            smproperty.GetElement(0)), here)
        if smproperty.GetInformationOnly():
            assert element.get("default_values") is not None, here
            continue
        basic += smproperty.GetPanelVisibility() == "default"
        check_range(instance, key, smproperty, here)
    missing = properties_of(instance) - names - {"FileName"}
    assert not missing, f"{where}: not in the panel: {missing}"
    assert basic <= 6, f"{where}: {basic} basic properties"

    # Ports: as many, of the same types, optional or not.
    assert proxy.GetNumberOfOutputPorts() == instance.GetNumberOfOutputPorts(), where
    inputs = definition.findall("InputProperty")
    assert len(inputs) == instance.GetNumberOfInputPorts(), where
    for element in inputs:
        port = int(element.get("port_index"))
        information = instance.GetInputPortInformation(port)
        types = [e.get("value") for e in element.iter("DataType")]
        assert types == [information.Get(vtkAlgorithm.INPUT_REQUIRED_DATA_TYPE(), 0)], where
        optional = bool(information.Get(vtkAlgorithm.INPUT_IS_OPTIONAL()))
        assert (element.find("Hints/Optional") is not None) == optional, f"{where} {port}"
        assert (element.get("null_on_empty") == "1") == optional, f"{where} {port}"
    check_groups(definition, where)
    if group == "sources":
        factory = definition.find("Hints/ReaderFactory")
        assert factory.get("extensions") and factory.get("file_description"), where
    if group == "filters":
        check_menu(definition, where)
        # Where the name of the class says it, the simple function makes it.
        assert callable(getattr(simple, words.replace(" ", ""))), where
    print(where, sorted(names))


seen = set()
for path in sorted(glob.glob(os.path.join(RESOURCES, "*.xml"))):
    root = ElementTree.parse(path).getroot()
    for section in root.iter("ProxyGroup"):
        for child in section:
            if section.get("name") in ("filters", "sources"):
                check_proxy(section.get("name"), child)
                seen.add(child.get("class"))
            else:
                writer = manager.NewProxy(section.get("name"), child.get("name"))
                assert writer, child.get("name")
                writer.UpdateVTKObjects()
                documented(writer, child.get("name"))
                if section.get("name") == "writers":
                    check_writer(child, child.get("name"))
                seen.add(child.get("class"))

# No filter of the pipeline is left out.
for path in glob.glob(os.path.join(
        os.environ["FEATUREHEX_SOURCE_DIR"], "Filters", "Pipeline", "vtk*.cxx")):
    with open(path, encoding="utf-8") as file:
        classes = re.findall(r"vtkStandardNewMacro\((\w+)\)", file.read())
    for name in classes:
        assert name in seen or name == "vtkFeatureHexVersion", f"{name} has no proxy"
