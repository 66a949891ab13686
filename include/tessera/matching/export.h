/// @file
/// Marks the symbols that libtessera-matching.so exports.
#pragma once

#define TESSERA_MATCHING_API __attribute__((visibility("default")))
