DefineConstant[ width = 2, Height = 1, rad = 0.1, RAD = 0.2 ];
side = 3;
