"""The hero's few colours."""

from hero_shapes import Paint

STEEL = Paint(0xCBD4DB)
PLATE = Paint(0xA9B5C1)  # steel of arms and legs
BRIGHT = Paint(0xEDF1F2, variety=0.03)  # edges that catch the light
SHADE = Paint(0x8E9BA8)  # plates under plates
DARK = Paint(0x333C49)  # padding and mail
BLACK = Paint(0x14181F, variety=0.0)
CLOTH = Paint(0x2A6A80)
CLOTH_EDGE = Paint(0x3F8C9E, variety=0.04)
CLOTH_INSIDE = Paint(0x1C4656)
LEATHER = Paint(0x6B4630)
LEATHER_DARK = Paint(0x442B1F)
LEATHER_EDGE = Paint(0x8A6040)
RED = Paint(0xD8372A, variety=0.09)
RED_EDGE = Paint(0xF05A3C, variety=0.04)
LINING = Paint(0x7E1B25)
BRASS = Paint(0xDCA54C)
BRASS_DARK = Paint(0x9C6A2C)
FLAME = Paint(0xFFC35E, glow=True, variety=0.04)
FLAME_HEART = Paint(0xFFEDB0, glow=True, variety=0.0)
EYES = Paint(0xFFD27A, glow=True, variety=0.0)
