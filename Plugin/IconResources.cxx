// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Icons of the plugin as a resource of Qt, :/FeatureHex/NAME.svg.
///
/// Where there is a Qt, in ParaView's window, its function is called when the plugin is loaded and
/// unloaded. Everywhere else (pvpython, pvbatch, pvserver) there is none, and nothing happens: the
/// plugin is linked without Qt, and needs no headers of it.

bool qRegisterResourceData(int version, const unsigned char* tree, const unsigned char* name,
  const unsigned char* data) __attribute__((weak));
bool qUnregisterResourceData(int version, const unsigned char* tree, const unsigned char* name,
  const unsigned char* data) __attribute__((weak));

// What the resource compiler writes takes these functions from the namespace of Qt.
namespace WhereThereIsQt
{
bool qRegisterResourceData(
  int version, const unsigned char* tree, const unsigned char* name, const unsigned char* data)
{
  return ::qRegisterResourceData && ::qRegisterResourceData(version, tree, name, data);
}

bool qUnregisterResourceData(
  int version, const unsigned char* tree, const unsigned char* name, const unsigned char* data)
{
  return ::qUnregisterResourceData && ::qUnregisterResourceData(version, tree, name, data);
}
} // namespace WhereThereIsQt

#define QT_NAMESPACE WhereThereIsQt
#include "CompiledIcons.h"
