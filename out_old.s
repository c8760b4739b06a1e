cl_f:
.LFB4815:
	pushq	%rbp
	movq	%r8, %r11
	vxorpd	%xmm1, %xmm1, %xmm1
	movq	%rsp, %rbp
	pushq	%r15
	pushq	%r14
	pushq	%r13
	movq	%rdx, %r13
	pushq	%r12
	movq	%rsi, %r12
	movq	%rcx, %rsi
	xorl	%ecx, %ecx
	pushq	%rbx
	movq	%rsi, %rax
	movq	%rdi, %rbx
	movl	$15, %edi
	andq	$-32, %rsp
	subq	$3528, %rsp
	movq	%r12, 1328(%rsp)
	leaq	1288(%rsp), %r14
	leaq	200(%rsp), %r15
	movq	$0x000000000, 1344(%rsp)
	vmovq	.LC14(%rip), %xmm4
	vmovsd	.LC4(%rip), %xmm3
	movl	$15, 1336(%rsp)
	vmovsd	.LC1(%rip), %xmm9
.L98:
	cmpq	%r12, %rcx
	jnb	.L89
	movq	%rcx, %rsi
	movq	%r14, (%rsp)
	vmovss	0(%r13), %xmm8
	xorl	%r10d, %r10d
	salq	$4, %rsi
	vmovss	8(%r13), %xmm7
	vmovss	4(%r13), %xmm6
	xorl	%r8d, %r8d
	vmovss	12(%r13), %xmm5
	addq	%r15, %rsi
	jmp	.L94
.L187:
	vaddsd	%xmm0, %xmm1, %xmm0
.L90:
	vmovss	4(%rbx,%rcx,8), %xmm10
	vmovaps	%xmm10, %xmm1
	vcvtss2sd	%xmm1, %xmm1, %xmm1
	vmovsd	%xmm1, 8(%rsi)
	vandpd	%xmm4, %xmm1, %xmm1
	vcomisd	%xmm1, %xmm3
	jbe	.L170
	vaddsd	%xmm1, %xmm0, %xmm1
.L92:
	xorl	%edx, %edx
	vcomiss	%xmm10, %xmm5
	setb	%dl
	xorl	%r9d, %r9d
	sall	$2, %edx
	vcomiss	%xmm6, %xmm10
	setb	%r9b
	xorl	%r14d, %r14d
	orl	%edx, %r9d
	addl	%r9d, %r9d
	vcomiss	%xmm2, %xmm7
	setb	%r14b
	xorl	%edx, %edx
	sall	$2, %r14d
	vcomiss	%xmm8, %xmm2
	setb	%dl
	addq	$1, %rcx
	addq	$16, %rsi
	orl	%r14d, %edx
	orl	%r9d, %edx
	andl	%edx, %edi
	shlx	%r8, %rdx, %rdx
	addl	$4, %r8d
	orq	%rdx, %r10
	cmpl	$63, %r8d
	ja	.L171
	cmpq	%r12, %rcx
	jnb	.L171
.L94:
	vmovss	(%rbx,%rcx,8), %xmm2
	vmovaps	%xmm2, %xmm0
	vcvtss2sd	%xmm0, %xmm0, %xmm0
	vmovsd	%xmm0, (%rsi)
	vandpd	%xmm4, %xmm0, %xmm0
	vcomisd	%xmm0, %xmm3
	ja	.L187
	vmovsd	%xmm9, %xmm9, %xmm0
	jmp	.L90
.L170:
	vmovsd	%xmm9, %xmm9, %xmm1
	jmp	.L92
.L171:
	movq	(%rsp), %r14
	movl	%edi, 1336(%rsp)
	vmovsd	%xmm1, 1344(%rsp)
	addq	$8, %r14
	movq	%r10, -8(%r14)
	cmpl	$63, %r8d
	ja	.L98
	movq	%rax, %rsi
	jmp	.L97
.L89:
	movq	$0, (%r14)
	movq	%rax, %rsi
.L97:
	vmovsd	200(%rsp), %xmm0
	addq	%r12, %r12
	vcomisd	.LC12(%rip), %xmm1
	vmovsd	%xmm0, 200(%rsp,%r12,8)
	vmovsd	208(%rsp), %xmm0
	vmovsd	%xmm0, 208(%rsp,%r12,8)
	jbe	.L99
	vmovsd	.LC15(%rip), %xmm0
	vcomisd	%xmm1, %xmm0
	jbe	.L99
	testl	%edi, %edi
	jne	.L102
	vmovddup	%xmm1, %xmm1
	movq	1288(%rsp), %rax
	vmovss	0(%r13), %xmm2
	vmulpd	.LC16(%rip), %xmm1, %xmm1
	vmovss	4(%r13), %xmm4
	movl	%eax, %r8d
	movl	%eax, %ebx
	movq	%rax, -8(%rsp)
	vmovss	8(%r13), %xmm3
	andl	$5, %r8d
	andl	$15, %ebx
	movl	%r8d, %eax
	vunpcklps	%xmm2, %xmm4, %xmm0
	movl	%ebx, -76(%rsp)
	vunpckhpd	%xmm1, %xmm1, %xmm9
	vmovapd	%xmm1, 168(%rsp)
	vcvtps2pd	%xmm0, %xmm7
	vmovss	12(%r13), %xmm0
	negl	%eax
	vunpcklps	%xmm3, %xmm0, %xmm14
	vunpcklps	%xmm0, %xmm3, %xmm5
	vmovapd	%xmm7, -56(%rsp)
	vunpcklps	%xmm0, %xmm2, %xmm0
	vunpcklps	%xmm4, %xmm3, %xmm3
	vunpcklps	%xmm4, %xmm2, %xmm2
	sbbl	%r14d, %r14d
	vmovlhps	%xmm3, %xmm2, %xmm2
	vmovlhps	%xmm5, %xmm0, %xmm0
	vcvtps2pd	%xmm14, %xmm14
	andl	$12, %r14d
	movq	1328(%rsp), %rax
	vcvtps2pd	%xmm2, %ymm2
	vcvtps2pd	%xmm0, %ymm0
	vmovapd	%ymm2, 72(%rsp)
	vmovapd	%ymm0, 104(%rsp)
	movq	%rax, -72(%rsp)
	vmovapd	%xmm7, 136(%rsp)
	vmovapd	%xmm14, 152(%rsp)
	testq	%rax, %rax
	je	.L137
	leaq	200(%rsp), %rbx
	xorl	%ecx, %ecx
	xorl	%r15d, %r15d
	xorl	%edx, %edx
	movq	%rbx, (%rsp)
	xorl	%eax, %eax
	vxorpd	%xmm13, %xmm13, %xmm13
	vmovapd	%xmm1, %xmm3
	leaq	1352(%rsp), %rbx
	movl	%r8d, -80(%rsp)
	vmovddup	.LC1(%rip), %xmm4
	movq	%rbx, -64(%rsp)
	movq	%r11, -120(%rsp)
	movq	%rsi, -112(%rsp)
	movq	%rcx, %rsi
.L120:
	movq	-72(%rsp), %rcx
	movl	$16, %r8d
	movl	-76(%rsp), %r9d
	subq	%rsi, %rcx
	cmpq	%r8, %rcx
	cmovbe	%rcx, %r8
	cmpq	%rcx, %r8
	jnb	.L106
	movq	%rsi, %rcx
	shrq	$4, %rcx
	movq	1296(%rsp,%rcx,8), %r9
	andl	$15, %r9d
.L106:
	movq	-8(%rsp), %rbx
	leaq	-4(,%r8,4), %rcx
	shlx	%rcx, %r9, %rcx
	movq	%rbx, %r9
	shrq	$4, %r9
	orq	%r9, %rcx
	movq	%rcx, %r11
	movq	%rcx, -16(%rsp)
	movq	%rbx, %rcx
	xorq	%r11, %rcx
	movq	%rcx, %r9
	shrq	$2, %r9
	orq	%rcx, %r9
	movq	%rbx, %rcx
	shrq	$2, %rcx
	movq	%r9, %r10
	orq	%rbx, %rcx
	shrq	%r10
	andn	%r10, %rcx, %rbx
	movl	$16, %ecx
	orq	%r9, %rbx
	subq	%r8, %rcx
	movabsq	$1229782938247303441, %r8
	salq	$2, %rcx
	shrx	%rcx, %r8, %r8
	andq	%r8, %rbx
	je	.L138
	movq	%rsi, -88(%rsp)
	leaq	(%rsi,%rsi), %rcx
	vxorpd	%xmm12, %xmm12, %xmm12
	vpermilpd	$0, %xmm3, %xmm7
	movq	%rcx, -24(%rsp)
	leaq	_ZN3irg6detail10edge_kindsE(%rip), %r12
	xorl	%ecx, %ecx
	leaq	_ZN3irg6detail12edge_outputsE(%rip), %r11
	vmovapd	%xmm7, -40(%rsp)
	vmovddup	.LC11(%rip), %xmm10
	vmovapd	%xmm3, -104(%rsp)
.L117:
	xorl	%r9d, %r9d
	tzcntq	%rbx, %r9
	shrx	%r9, -8(%rsp), %rsi
	andl	$15, %esi
	orq	%rcx, %rsi
	shrx	%r9, -16(%rsp), %rcx
	salq	$4, %rcx
	movzbl	%cl, %ecx
	shrq	%r9
	orq	%rcx, %rsi
	movq	-24(%rsp), %rcx
	movsbq	4(%r12,%rsi,8), %r8
	addq	%rcx, %r9
	leaq	2(%r9), %r13
	movq	%r13, %rcx
	subq	%rdx, %rcx
	andq	%rcx, %r8
	leaq	(%rax,%r8), %r10
	leaq	8(%r10), %rcx
	cmpq	$272, %rcx
	ja	.L181
	movq	(%rsp), %rcx
	leaq	(%rcx,%rdx,8), %rdx
	movq	-64(%rsp), %rcx
	leaq	(%rcx,%rax,8), %rax
	xorl	%ecx, %ecx
.L109:
	addq	$8, %rcx
	vmovupd	(%rdx), %xmm3
	addq	$64, %rax
	addq	$64, %rdx
	vmovupd	-48(%rdx), %xmm2
	vmovupd	-32(%rdx), %xmm1
	vmovupd	-16(%rdx), %xmm0
	vmovupd	%xmm3, -64(%rax)
	vmovupd	%xmm2, -48(%rax)
	vmovupd	%xmm1, -32(%rax)
	vmovupd	%xmm0, -16(%rax)
	cmpq	%r8, %rcx
	jb	.L109
	movq	(%rsp), %rcx
	vmovddup	.LC7(%rip), %xmm0
	movzbl	(%r12,%rsi,8), %eax
	leaq	(%rcx,%r9,8), %rdx
	vmovdqu	72(%rsp,%rax,8), %xmm5
	movl	$0, %r9d
	movzbl	1(%r12,%rsi,8), %eax
	vmovupd	(%rdx), %xmm2
	vmovupd	16(%rdx), %xmm1
	xorl	%edx, %edx
	vsubpd	%xmm2, %xmm1, %xmm3
	vsubpd	%xmm2, %xmm5, %xmm6
	vpermilpd	$1, %xmm2, %xmm2
	vsubpd	%xmm5, %xmm1, %xmm1
	vdivpd	%xmm3, %xmm0, %xmm0
	vpermilpd	$1, %xmm3, %xmm7
	vmovapd	%xmm3, 8(%rsp)
	vmulpd	%xmm6, %xmm7, %xmm8
	vmovapd	%xmm6, 40(%rsp)
	vandpd	%xmm10, %xmm1, %xmm1
	vandpd	%xmm10, %xmm6, %xmm6
	vminpd	%xmm1, %xmm6, %xmm1
	vmovapd	-40(%rsp), %xmm6
	vcmpeqpd	%xmm12, %xmm7, %xmm7
	vmulpd	%xmm8, %xmm0, %xmm0
	vaddpd	%xmm0, %xmm2, %xmm2
	vsubsd	%xmm9, %xmm2, %xmm8
	vaddsd	%xmm9, %xmm2, %xmm3
	vaddsd	%xmm13, %xmm2, %xmm0
	vunpckhpd	%xmm2, %xmm2, %xmm2
	vsubsd	%xmm9, %xmm2, %xmm15
	vcvtsd2ss	%xmm8, %xmm8, %xmm8
	vcvtsd2ss	%xmm3, %xmm3, %xmm3
	vcvtsd2ss	%xmm0, %xmm0, %xmm0
	vcvtsd2ss	%xmm15, %xmm15, %xmm15
	vucomiss	%xmm3, %xmm8
	vaddsd	%xmm9, %xmm2, %xmm3
	vaddsd	%xmm13, %xmm2, %xmm2
	setnp	%dl
	vcvtsd2ss	%xmm2, %xmm2, %xmm2
	vcvtsd2ss	%xmm3, %xmm3, %xmm3
	cmovne	%r9, %rdx
	xorl	%ecx, %ecx
	vunpcklps	%xmm2, %xmm0, %xmm0
	negq	%rdx
	vcvtps2pd	%xmm0, %xmm0
	vsubpd	-56(%rsp), %xmm0, %xmm8
	vsubpd	%xmm0, %xmm14, %xmm11
	movq	%rdx, %r8
	vminpd	%xmm11, %xmm8, %xmm2
	vucomiss	%xmm3, %xmm15
	vunpcklpd	%xmm11, %xmm8, %xmm8
	vmovmskpd	%xmm8, %edx
	vandpd	%xmm10, %xmm2, %xmm2
	setnp	%cl
	vminpd	%xmm2, %xmm1, %xmm2
	vcmpeqpd	%xmm4, %xmm5, %xmm1
	vpermilpd	$1, %xmm4, %xmm4
	cmovne	%r9, %rcx
	vcmpeqpd	%xmm4, %xmm0, %xmm4
	negq	%rcx
	vcmpltpd	%xmm2, %xmm6, %xmm2
	vmovq	%r8, %xmm6
	vpinsrq	$1, %rcx, %xmm6, %xmm3
	vandpd	%xmm4, %xmm1, %xmm1
	vpor	%xmm7, %xmm3, %xmm3
	vpandn	%xmm2, %xmm1, %xmm1
	vpand	%xmm1, %xmm3, %xmm1
	vmovmskpd	%xmm1, %ecx
	vaddpd	%xmm5, %xmm12, %xmm1
	andn	%eax, %ecx, %ecx
	movzwl	2(%r12,%rsi,8), %eax
	orl	%ecx, %edi
	leaq	0(,%r10,8), %rsi
	addl	%r14d, %eax
	addl	%edx, %eax
	cmpl	$12, %r14d
	movl	%eax, %eax
	cmove	%edx, %r15d
	blsr	%rbx, %rcx
	movzbl	(%r11,%rax,8), %edx
	movzbl	5(%r11,%rax,8), %r14d
	vmovhpd	72(%rsp,%rdx,8), %xmm1, %xmm7
	movzbl	6(%r11,%rax,8), %edx
	vmovupd	%xmm7, 1352(%rsp,%r10,8)
	testb	%dl, %dl
	jne	.L111
.L114:
	movq	%rcx, %rbx
	xorl	%ecx, %ecx
.L112:
	movzbl	2(%r11,%rax,8), %edx
	vunpcklpd	%xmm0, %xmm5, %xmm1
	vunpckhpd	%xmm5, %xmm0, %xmm0
	addq	%r10, %rdx
	vmovupd	%xmm1, 1352(%rsp,%rdx,8)
	movzbl	3(%r11,%rax,8), %edx
	movzbl	4(%r11,%rax,8), %eax
	addq	%r10, %rdx
	vmovupd	%xmm0, 1352(%rsp,%rdx,8)
	addq	%r10, %rax
	je	.L115
	vmovupd	1336(%rsp,%rax,8), %xmm4
	testq	%rbx, %rbx
	je	.L172
.L116:
	movq	%r13, %rdx
	jmp	.L117
.L115:
	vmovapd	1352(%rsp), %xmm4
	testq	%rbx, %rbx
	jne	.L116
.L172:
	movq	-88(%rsp), %rsi
	vmovapd	-104(%rsp), %xmm3
.L107:
	movq	-72(%rsp), %rbx
	addq	$16, %rsi
	cmpq	%rbx, %rsi
	jnb	.L188
	movq	%rsi, %rdx
	shrq	$4, %rdx
	movq	1288(%rsp,%rdx,8), %rbx
	movq	%r13, %rdx
	movq	%rbx, -8(%rsp)
	jmp	.L120
.L188:
	leaq	-1(%rbx), %rdx
	movl	-80(%rsp), %r8d
	movq	-112(%rsp), %rsi
	movq	%rdx, %rcx
	andl	$15, %edx
	movq	-120(%rsp), %r11
	shrq	$4, %rcx
	salq	$2, %rdx
	movq	1288(%rsp,%rcx,8), %rcx
	shrx	%rdx, %rcx, %rdx
	xorl	%ecx, %ecx
	andl	$15, %edx
	leaq	(%rbx,%rbx), %rdx
	sete	%cl
	subq	%r13, %rdx
	negq	%rcx
	andq	%rdx, %rcx
	movq	%rcx, -72(%rsp)
	addq	%rax, %rcx
	leaq	8(%rcx), %rdx
	cmpq	$272, %rdx
	jbe	.L104
.L181:
	vzeroupper
.L99:
	movq	$-1, %rcx
.L88:
	leaq	-40(%rbp), %rsp
	movq	%rcx, %rax
	popq	%rbx
	popq	%r12
	popq	%r13
	popq	%r14
	popq	%r15
	popq	%rbp
	ret
.L111:
	testb	$4, %dl
	jne	.L181
	leaq	16(%r10), %r8
	cmpq	$272, %r8
	ja	.L181
	testb	$2, %dl
	je	.L113
	movzbl	1(%r11,%rax,8), %r8d
	vmovhpd	72(%rsp,%r8,8), %xmm1, %xmm7
	vmovupd	%xmm7, 1368(%rsp,%rsi)
.L113:
	andl	$1, %edx
	je	.L114
	movl	$256, %ecx
	jmp	.L112
.L138:
	movq	%rdx, %r13
	jmp	.L107
.L183:
	vzeroupper
.L102:
	xorl	%ecx, %ecx
	jmp	.L88
.L137:
	xorl	%eax, %eax
	xorl	%ecx, %ecx
	xorl	%r15d, %r15d
	xorl	%r13d, %r13d
.L104:
	leaq	1352(%rsp), %rdx
	leaq	200(%rsp,%r13,8), %r9
	xorl	%r10d, %r10d
	leaq	(%rdx,%rax,8), %rax
.L121:
	movq	-72(%rsp), %rbx
	addq	$8, %r10
	addq	$64, %r9
	vmovupd	-64(%r9), %xmm3
	vmovupd	-48(%r9), %xmm2
	vmovupd	-32(%r9), %xmm1
	addq	$64, %rax
	vmovupd	-16(%r9), %xmm0
	vmovupd	%xmm3, -64(%rax)
	vmovupd	%xmm2, -48(%rax)
	vmovupd	%xmm1, -32(%rax)
	vmovupd	%xmm0, -16(%rax)
	cmpq	%rbx, %r10
	jb	.L121
	testl	%edi, %edi
	jne	.L181
	testl	%r8d, %r8d
	je	.L124
	movl	-76(%rsp), %eax
	leal	320(%r14,%r15), %edi
	shrl	%eax
	andl	$2, %eax
	vmovdqa	72(%rsp,%rax,8), %xmm0
	leaq	_ZN3irg6detail12edge_outputsE(%rip), %rax
	testb	$4, 6(%rax,%rdi,8)
	jne	.L181
	vxorpd	%xmm1, %xmm1, %xmm1
	movzbl	(%rax,%rdi,8), %r8d
	vaddpd	%xmm1, %xmm0, %xmm0
	vmovhpd	72(%rsp,%r8,8), %xmm0, %xmm5
	movzbl	1(%rax,%rdi,8), %r8d
	movzbl	4(%rax,%rdi,8), %eax
	vmovupd	%xmm5, 1352(%rsp,%rcx,8)
	vmovhpd	72(%rsp,%r8,8), %xmm0, %xmm5
	vmovupd	%xmm5, 1368(%rsp,%rcx,8)
	addq	%rax, %rcx
.L124:
	cmpq	$2, %rcx
	jbe	.L183
	vmovsd	1352(%rsp), %xmm1
	vmovsd	1360(%rsp), %xmm0
	jmp	.L125
.L189:
	vucomisd	-8(%rdx,%rcx,8), %xmm0
	jp	.L126
	jne	.L126
	subq	$2, %rcx
	cmpq	$2, %rcx
	jbe	.L126
.L125:
	vucomisd	-16(%rdx,%rcx,8), %xmm1
	jp	.L126
	je	.L189
.L126:
	cmpq	$5, %rcx
	jbe	.L183
	shrq	%rcx
	testq	%r11, %r11
	je	.L185
	vxorps	%xmm2, %xmm2, %xmm2
	xorl	%eax, %eax
	jmp	.L132
.L133:
	addq	$16, %rdx
	cmpq	%rax, %rcx
	jle	.L185
.L132:
	vcvtsd2ss	8(%rdx), %xmm2, %xmm1
	vcvtsd2ss	(%rdx), %xmm2, %xmm0
	vunpcklps	%xmm1, %xmm0, %xmm0
	vmovlps	%xmm0, (%rsi,%rax,8)
	addq	$1, %rax
	cmpq	%rax, %r11
	jne	.L133
.L185:
	vzeroupper
	jmp	.L88
.LFE4815:
	.globl	codes
