# rasterdiff_embed_text(OUT SYMBOL FILE): a header with the text of FILE as `inline constexpr char SYMBOL[]`.
function(rasterdiff_embed_text out symbol file)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
  file(READ ${file} content)
  file(CONFIGURE OUTPUT ${out} CONTENT
"#pragma once
namespace rasterdiff {
inline constexpr char ${symbol}[] = R\"__EMBED__(@content@)__EMBED__\";
}
" @ONLY)
endfunction()
